// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "expr/tree/tree.h"

namespace rigor {

/// `3`, `-2`, `4 + 1`: the whole number that an expression without letters is, if it is a small one.
[[nodiscard]] std::optional<int> whole_number_of(const ExprTree& tree, ExprId id);

}  // namespace rigor
