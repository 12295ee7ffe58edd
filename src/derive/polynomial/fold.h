// SPDX-License-Identifier: GPL-3.0-or-later
// Index notation folded back to direct notation: A_i B_i → A·B, A_i A_i → A², ε_ijk A_j B_k → (A×B)_i or
// A·(B×C), I_ij ω_j → (I·ω)_i.
#pragma once

#include <optional>
#include <span>

#include "derive/polynomial/index_polynomial.h"

namespace rigor {

/// An expression of as many axes as `open` has letters (at most 2), whose components at these letters are the
/// polynomial. Other free letters stay as components. Nothing where a sum is left that direct notation has no
/// sign for (δ_ij with both letters open, tensors of higher rank).
[[nodiscard]] std::optional<ExprId> folded(ExprTree& tree, const IndexPolynomial& polynomial,
                                           std::span<const IndexId> open = {});

}  // namespace rigor
