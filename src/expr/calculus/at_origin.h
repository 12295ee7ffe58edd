// SPDX-License-Identifier: GPL-3.0-or-later
// What an expression is where its variables are 0: `A(\omega_0^2 - \omega^2)\cos(\omega t - \delta)` at t =
// 0.
#pragma once

#include <optional>
#include <set>

#include "expr/tree/tree.h"

namespace rigor {

/// With 0 for the variables, and without the terms that vanish with them. Nothing where the expression need
/// not be smooth there: a variable below a line, under a root or in a logarithm. Recursion: as deep as the
/// tree.
[[nodiscard]] std::optional<ExprId> at_origin(ExprTree& tree, ExprId id, const std::set<SymbolId>& variables);

}  // namespace rigor
