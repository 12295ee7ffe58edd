// SPDX-License-Identifier: GPL-3.0-or-later
// An expression multiplied out, its index sums carried out as far as they go, and folded to direct notation.
#pragma once

#include <optional>

#include "derive/polynomial/index_polynomial.h"

namespace rigor {

/// ε and δ contracted, rotations and unit vectors as well, equal terms added up.
void contract(ExprTree& tree, IndexPolynomial& polynomial);

/// |A×B|² → A²B² − (A·B)². An expression of rank 0 may have free letters; of rank 2 there is no direct
/// notation for δ. Nothing where it is too large, or where direct notation has no sign for it.
[[nodiscard]] std::optional<ExprId> contracted(ExprTree& tree, ExprId id);

/// The same for an expression of rank 0, left in index notation: (A×B)_i → ε_ijk A_j B_k.
[[nodiscard]] std::optional<ExprId> in_indices(ExprTree& tree, ExprId id);

/// Back to an expression of rank 0 with good letters: folded if that can be done.
[[nodiscard]] ExprId as_scalar(ExprTree& tree, const IndexPolynomial& polynomial);

}  // namespace rigor
