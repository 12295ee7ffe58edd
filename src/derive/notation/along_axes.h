// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over components written out along the axes 1, 2, 3.
#pragma once

#include <optional>
#include <span>

#include "expr/tree/tree.h"

namespace rigor {

/// The component of an expression at numbered axes: every sum over an index is three terms, δ and ε are
/// numbers, direct notation is gone; nothing is multiplied out. Terms that are 0 are left out. `variables`
/// are the letters that stand for `axes`. Nothing where it is too large.
[[nodiscard]] std::optional<ExprId> along_axes(ExprTree& tree, ExprId id, std::span<const IndexId> variables,
                                               std::span<const std::uint8_t> axes);

}  // namespace rigor
