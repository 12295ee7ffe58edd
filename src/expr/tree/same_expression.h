// SPDX-License-Identifier: GPL-3.0-or-later
// Whether two expressions have one structure.
#pragma once

#include "expr/tree/tree.h"

namespace rigor {

/// The same operations in the same order, but for
/// * the names of bound indices and particles, and the order of index sums that stand directly in one
/// another,
/// * what the notation cannot say: scalars are before vectors in a product, a product in a product is one
///   product, and so is a component of a lone symbol its component in brackets,
/// * a first power, which is its base, a written 0, which is that of any rank, and spans.
/// Free indices, free particles and, between different trees, symbols (but for their faces) are compared by
/// their names. Cost: linear in the weight. Recursion: as deep as the tree.
[[nodiscard]] bool same_expression(const ExprTree& a, ExprId a_root, const ExprTree& b, ExprId b_root);

}  // namespace rigor
