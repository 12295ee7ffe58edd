// SPDX-License-Identifier: GPL-3.0-or-later
// Statements that are true by their form alone, and say nothing.
#pragma once

#include "expr/tree/tree.h"

namespace rigor {

/// The sides are one expression, terms of a side or of a sum in it cancel (`\mathbf v - \mathbf v`), or both
/// are 0 as they are written (`0\,a = 0`). An identity such as `\nabla\times\nabla f = 0` is none of these.
[[nodiscard]] bool is_trivial(const ExprTree& tree, ExprId left, ExprId right);

/// The same with factors and terms in any order, and products written as powers: `xy = yx`, `xx = x^2`; not
/// of operators.
[[nodiscard]] bool is_trivial_up_to_order(const ExprTree& tree, ExprId left, ExprId right);

}  // namespace rigor
