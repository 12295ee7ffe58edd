// SPDX-License-Identifier: GPL-3.0-or-later
// Matrices and columns of any size: what a product of them is.
#pragma once

#include "expr/tree/tree.h"

namespace rigor {

/// A number can stand for a multiple of the unit matrix; `none`: rows and columns do not fit together.
enum class UnsizedShape : std::uint8_t { number, matrix, column, row, none };

/// Does it hold operators, and are all of them matrices or columns of any size?
[[nodiscard]] bool is_unsized(const ExprTree& tree, ExprId root);

/// Of what has a matrix or a column of any size in it; a number of all else. Recursion: as deep as the tree.
[[nodiscard]] UnsizedShape unsized_shape(const ExprTree& tree, ExprId root);

}  // namespace rigor
