// SPDX-License-Identifier: GPL-3.0-or-later
// How an expression is built, whatever its summed letters are called and in whatever order its terms and
// factors stand.
#pragma once

#include <string>

#include "expr/tree/tree.h"

namespace rigor {

[[nodiscard]] std::string shape_of(const ExprTree& tree, ExprId root);

}  // namespace rigor
