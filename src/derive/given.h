// SPDX-License-Identifier: GPL-3.0-or-later
// An equation that holds, used on a sum of monomials: where one side's monomial stands as factors, the other
// side is put in.
#pragma once

#include "derive/index_polynomial.h"
#include "expr/statement.h"

namespace rigor {

/// What is replaced, and by what. Free letters of the equation stand for any.
struct Replacement {
  IndexMonomial pattern;
  IndexPolynomial by;
  std::vector<IndexId> indices = {};
  std::vector<ParticleId> particles = {};
};

/// left → right, if left is one monomial; else right → left, if right is; else the first term of left is
/// replaced by all others. Nothing for an equation of no use (no term, too large, no order).
[[nodiscard]] std::optional<Replacement> replacement_of(ExprTree& tree, const Equation& equation);

/// Puts it in as often as it fits, within a bound. False where it does not fit, or where it grows too large.
bool replace_given(ExprTree& tree, const Replacement& replacement, IndexPolynomial& polynomial);

}  // namespace rigor
