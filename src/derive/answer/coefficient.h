// SPDX-License-Identifier: GPL-3.0-or-later
// A tensor that is multiplied with vectors and summed over, by comparing coefficients: from
// ½ □_ij ω_i ω_j = Σ ½ m (r² ω_i ω_i − r_i r_j ω_i ω_j) follows □_ij = Σ m (r² δ_ij − r_i r_j), if it is not
// to depend on the vectors.
#pragma once

#include <optional>

#include "expr/statement/statement.h"

namespace rigor {

/// The hole is on the right side of the claim, at letters, once, in one product with numbers, scalars and
/// components of vectors at its letters. Each term of the left side must have these vectors as factors. An
/// expression of rank 0 with the hole's letters free; nothing where this is not so. That it fits is not said.
[[nodiscard]] std::optional<ExprId> coefficient_of_vectors(ExprTree& tree, const Equation& claim,
                                                           SymbolId hole);

}  // namespace rigor
