// SPDX-License-Identifier: GPL-3.0-or-later
// An expression as LaTeX that a reader of the notes would have written, and that reads back as the same
// expression.
#pragma once

#include <string>

#include "expr/print/notation.h"
#include "expr/tree/tree.h"

namespace rigor {

/// Read where the expression's names are in scope, what is printed has the same structure
/// (`same_expression`), unless it cannot be written in the notation that is read: a power of a component with
/// a free index, a letter that occurs twice and is not summed (that takes "no sum" next to the equation).
/// Brackets stand only where they are needed, sums over indices only where the summation convention does not
/// give them back. Bound letters keep their names unless another one in scope has the same.
/// Cost: linear in the weight of the expression times its depth in sums. Recursion: as deep as the tree.
[[nodiscard]] std::string print_latex(const ExprTree& tree, ExprId root, const Notation& notation = {});

}  // namespace rigor
