// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors of three matrices, `\boldsymbol\sigma`: the tuple of their matrices, of rank 3. What is made of
// them is a number, a vector, a matrix or again such a vector, so that what decides knows nothing of them.
#pragma once

#include <functional>

#include "elaborate/reading/reading.h"

namespace rigor {

[[nodiscard]] inline bool is_triple(const Typed& typed) { return typed.layout == Layout::triple; }

/// \sigma_i, the product of the unit vector e_i and the triple.
[[nodiscard]] Typed member_of(ExprTree& tree, const Typed& triple, Slot slot, std::vector<FreeIndex> free,
                              Span span);
/// The same operation on each of the three: again a triple where it gives matrices, a vector where numbers.
[[nodiscard]] MaybeTyped of_each_member(Reading& reading, const Typed& triple, Span span,
                                        const std::function<MaybeTyped(const Typed&)>& operation);

/// `\boldsymbol\sigma\cdot\mathbf a`, `\mathbf S\cdot\boldsymbol\sigma`: a matrix. A vector whose components
/// may not commute is ambiguous.
[[nodiscard]] MaybeTyped dot_with_triple(Reading& reading, const Typed& left, const Typed& right, Span span);
/// `\mathbf a\times\boldsymbol\sigma`, `\mathbf S\times\mathbf S`: (A×B)_i = ε_ijk A_j B_k.
[[nodiscard]] MaybeTyped cross_with_triple(Reading& reading, const Typed& left, const Typed& right,
                                           Span span);

// --- matrix_exponential.cpp

/// `e^{-i\theta\,\mathbf n\cdot\boldsymbol\sigma/2}`, with the Pauli matrices only.
[[nodiscard]] MaybeTyped matrix_exponential(Reading& reading, const Typed& argument, Span span);

}  // namespace rigor
