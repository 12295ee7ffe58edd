// SPDX-License-Identifier: GPL-3.0-or-later
// One side of a step taken down towards a common form: definitions unfolded, products written in components,
// multiplied out, ε and δ contracted, assumptions used, equal terms collected; one line for each rule.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "derive/chain/rule.h"
#include "derive/notation/letter_choice.h"
#include "derive/notation/transport.h"
#include "derive/polynomial/given.h"
#include "derive/polynomial/index_polynomial.h"
#include "expr/statement/statement.h"

namespace rigor {

struct NamedRule {
  Definition definition;
  std::string name;
};

struct NamedReplacement {
  Replacement replacement;
  std::string name;
};

/// In what notation lines are written.
enum class DescentNotation : std::uint8_t {
  direct,      // vectors stay vectors
  components,  // index notation
  axes,        // written out along the axes 1, 2, 3, each component by itself
};

/// What a descent may use, and how it goes.
struct DescentRules {
  std::vector<NamedRule> definitions = {};
  std::vector<NamedReplacement> replacements = {};
  std::vector<TurningFrame> frames = {};
  LetterChoice letters = {};
  std::vector<IndexId> free = {};  // letters
  std::vector<IndexId> open = {};  // in direct notation: letters for the axes of a side, to compare it by
  DescentNotation notation = DescentNotation::components;
  std::vector<ExprId> small = {};  // symbols and components: what is of second order is left out at the end
};

/// One expression on the way. What it became by `down` from the line before it, it leaves by `up`.
struct Line {
  std::vector<ExprId> parts;  // one; along axes, one for each value of the free letters and axes
  Rules down = {};
  Rules up = {};
  bool flat = false;                  // a sum of products
  std::vector<ExprId> left_out = {};  // of second order, and not in this line any more
  std::string shape = {};             // equal, with equal `terms`: the same but for letters and order
  std::string terms = {};             // empty: too large to be compared
};

struct Descent {
  std::vector<Line> lines;                   // the first is the side itself
  std::vector<IndexPolynomial> polynomials;  // of the last line's parts; none if it is too large
};

/// `side` has rank 0 if it is to be written in components.
[[nodiscard]] Descent descend(ExprTree& tree, ExprId side, const DescentRules& rules);

/// The lines N/D after the last ones, where both sides' quotients have a common denominator D.
void append_common_denominator(ExprTree& tree, const DescentRules& rules, Descent& left, Descent& right);

}  // namespace rigor
