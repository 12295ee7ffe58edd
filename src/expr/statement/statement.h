// SPDX-License-Identifier: GPL-3.0-or-later
// What the exact side is asked, and what it answers. No type of a computer algebra system appears here, so
// that a question can be asked in another process and an answer can be stored: exact values are rational
// numbers as text, `-3/2`.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "expr/statement/proof.h"
#include "expr/tree/tree.h"

namespace rigor {

/// `symbol` (of `particle`, if it has one) equals `body`. Either `indices` has one variable for each axis of
/// the symbol, and the body has rank 0; or `indices` is empty, and the body has the symbol's rank.
/// `by_square`: the notes define the symbol's square, which may be negative; the body is the root of it.
struct Definition {
  SymbolId symbol{};
  std::vector<IndexId> indices = {};
  ParticleId particle = no_particle;
  ExprId body{};
  bool by_square = false;
};

enum class Relation : std::uint8_t { equal, less, less_or_equal, unequal };

/// left = right (or <, ≤, ≠) for all values of the free indices and free particles; both sides have one rank,
/// which is 0 for an order.
struct Equation {
  ExprId left{};
  ExprId right{};
  std::vector<IndexId> indices = {};       // free
  std::vector<ParticleId> particles = {};  // free
  Relation relation = Relation::equal;
};

/// The symbol at its slots (and particle) equals the body.
[[nodiscard]] Equation as_equation(ExprTree& tree, const Definition& definition);

struct Question {
  const ExprTree* tree = nullptr;
  Equation claim;
  std::vector<Definition> definitions =
      {};  // in scope; unfolded only where needed, recursively, never circular
  std::vector<Equation> assumptions = {};  // in scope
  std::vector<SymbolId> zeroed = {};       // symbols taken as 0 (all their components)
};

/// The first one of the symbol; null: there is none.
[[nodiscard]] inline const Definition* definition_in(const Question& question, SymbolId symbol) {
  const auto found = std::ranges::find(question.definitions, symbol, &Definition::symbol);
  return found == question.definitions.end() ? nullptr : &*found;
}

enum class Outcome : std::uint8_t { proved, refuted, undecided };

/// One symbol's exact value in a sample: all components, row by row.
struct SampleValue {
  SymbolId symbol{};
  std::uint32_t particle = 0;  // from 1; 0 where the symbol has no particle label
  std::vector<std::string> components;
};

/// Exact values that meet the assumptions. In a refutation the sides differ there, which anyone can check by
/// putting the values in.
struct Sample {
  std::uint32_t particles = 0;  // how many; 0 where no statement needs any
  std::vector<SampleValue> values;
  std::vector<std::uint8_t> axes;  // the free indices' values, then the axes of a vector or tensor claim
  std::vector<std::uint32_t> free_particles;  // which particle each free particle variable is, from 1
  std::string left;
  std::string right;
};

/// Of a proved claim, `vanishes`, `route`, `unfolded` and `assumptions` are taken from the proof
/// (`proved_by`).
struct Decision {
  Outcome outcome = Outcome::undecided;
  bool vanishes = false;                      // proved, and each side is zero by itself
  std::string route;                          // `component normal form`, `moments`, `exact sample`…
  std::string reason = {};                    // undecided: why, and what was tried
  bool no_real_value = false;                 // undecided: a side has no real value under the assumptions
  std::vector<SymbolId> unfolded = {};        // definitions that were used
  std::vector<std::size_t> assumptions = {};  // positions in Question::assumptions that were used
  std::optional<Sample> sample = {};          // refuted
  std::optional<Proof> proof = {};            // proved here, not read from a record
};

/// The only function that copies what a proof used into a decision.
[[nodiscard]] Decision proved_by(Proof proof);

}  // namespace rigor
