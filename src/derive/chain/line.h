// SPDX-License-Identifier: GPL-3.0-or-later
// What lines of two descents are compared by.
#pragma once

#include "derive/chain/descent.h"

namespace rigor {

/// Fills `shape` and `terms`. `open`: letters for the axes of a line in direct notation.
void describe(ExprTree& tree, Line& line, const std::vector<IndexId>& open);

/// Does an operation occur anywhere in an expression?
[[nodiscard]] bool contains(const ExprTree& tree, ExprId root, Op op);

/// Do two lines say the same but for letters and order?
[[nodiscard]] bool meets(const Line& a, const Line& b);

/// The line as one expression: of several parts, a table by the free letters of the tuples of the others.
[[nodiscard]] ExprId as_expression(ExprTree& tree, const Line& line, const std::vector<IndexId>& free);

}  // namespace rigor
