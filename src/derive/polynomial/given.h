// SPDX-License-Identifier: GPL-3.0-or-later
// An equation that holds, used on a sum of monomials: where one side's monomial stands as factors, the other
// side is put in.
#pragma once

#include "derive/polynomial/index_polynomial.h"
#include "expr/statement/statement.h"

namespace rigor {

/// What is replaced, and by what. Free letters of the equation stand for any.
struct Replacement {
  IndexMonomial pattern;
  IndexPolynomial by;
  std::vector<IndexId> indices = {};
  std::vector<ParticleId> particles = {};
  bool inside = true;  // used under roots, in quotients and functions too: not where it fits its own, as in
                       // B_i → B_j B_j under a root · δ_i3
};

enum class Orientation : std::uint8_t {
  as_written,  // left → right, if left is one monomial; else right → left, if right is; else the first term
  leading,     // solved for the component that is differentiated most, by the time first
};

/// Nothing for an equation of no use (no term, too large, no equality, nothing to solve for).
[[nodiscard]] std::optional<Replacement> replacement_of(ExprTree& tree, const Equation& equation,
                                                        Orientation orientation);

/// n_3² → 1 − n_1² − n_2² of a unit vector.
[[nodiscard]] Replacement replacement_of_unit(ExprTree& tree, SymbolId unit);

/// Puts it in as often as it fits, within a bound. False where it does not fit, or where it grows too large.
bool replace_given(ExprTree& tree, const Replacement& replacement, IndexPolynomial& polynomial);

}  // namespace rigor
