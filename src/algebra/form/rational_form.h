// SPDX-License-Identifier: GPL-3.0-or-later
// Expressions written otherwise as rational functions: what is neither a sum, a product, a quotient nor a
// whole power is an indeterminate, as it stands. A·A and |A|² are one. Terms are in an order of our own: by
// the powers of the indeterminates in the order in which the expression names them, so that nothing of the
// computer algebra's order shows.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "expr/tree/tree.h"

namespace rigor {

enum class RationalForm : std::uint8_t {
  expanded,  // numerator and denominator multiplied out, common factors cancelled
  factored,  // both as products of irreducible polynomials with whole coefficients
};

/// The expression, of any rank, in this form; of rank above 0 only `expanded`, a sum of vectors with rational
/// functions before them. Nothing where it is too large (300 terms, powers up to 16) or divides by zero.
[[nodiscard]] std::optional<ExprId> rational_form(ExprTree& tree, ExprId id, RationalForm form);

/// The expression of rank 0 as a polynomial in some of its indeterminates (given as expressions), with
/// factored coefficients; the denominator, if it has one, may not have them. Nothing where that is not so.
[[nodiscard]] std::optional<ExprId> collected_by(ExprTree& tree, ExprId id, std::span<const ExprId> by);

/// The expression of rank 0 without what is of second or higher order in some of its indeterminates together.
/// Nothing where it is not defined at 0, or where one of them also is in another indeterminate.
[[nodiscard]] std::optional<ExprId> to_first_order(ExprTree& tree, ExprId id, std::span<const ExprId> in);

/// What an unknown must be for a difference to vanish.
struct Roots {
  std::vector<ExprId> values = {};  // one, or two that may be equal: with + and − before the square root
  std::string obstacle = {};        // why there are none
};

/// The difference has rank 0. The unknown is an indeterminate in it, given as an expression; it is solved for
/// if it stands to the first or second power. That the roots fit, that is, are real and no denominator
/// vanishes, is not said.
[[nodiscard]] Roots solved_for(ExprTree& tree, ExprId difference, ExprId unknown);

}  // namespace rigor
