// SPDX-License-Identifier: GPL-3.0-or-later
// A statement of the generator: letters, what is assumed of them, and a chain of relations.
#pragma once

#include <string>
#include <vector>

#include "term.h"

namespace fuzz {

enum class Relation { equal, less, less_or_equal, greater, greater_or_equal, unequal, nearly };

struct Claim {
  Term left, right;
  Relation relation = Relation::equal;
};

struct Statement {
  std::string kind;  // `vectors`: the class that it belongs to
  std::vector<Letter> letters;
  std::vector<Claim> given = {};
  std::vector<Term> sides = {};          // of the chain
  std::vector<Relation> relations = {};  // one less

  bool contradictory = false;  // nothing meets what is given, so that nothing may be proved

  [[nodiscard]] Claim step(std::size_t k) const { return {sides[k], sides[k + 1], relations[k]}; }
  [[nodiscard]] std::size_t steps() const { return relations.size(); }
};

/// A claim that is written by the rules: both sides have one rank and the same free indices.
[[nodiscard]] bool well_formed(const Claim& claim, const std::vector<Letter>& letters);
[[nodiscard]] bool well_formed(const Statement& statement);

}  // namespace fuzz
