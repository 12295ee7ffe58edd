// SPDX-License-Identifier: GPL-3.0-or-later
// An expression as LaTeX that a reader of the notes would have written, and that reads back as the same
// expression.
#pragma once

#include <string>

#include "expr/notation.h"
#include "expr/tree.h"

namespace rigor {

/// Reading what is printed gives an expression of the same structure (but for spans and sums that the
/// summation convention writes without a sign). Brackets stand only where they are needed.
/// Cost: linear in the weight of the expression.
[[nodiscard]] std::string print_latex(const ExprTree& tree, ExprId root, const Notation& notation = {});

}  // namespace rigor
