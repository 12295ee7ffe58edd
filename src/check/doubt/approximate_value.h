// SPDX-License-Identifier: GPL-3.0-or-later
// What a number is worth, roughly: to be shown beside a number that is wrong. Nothing is decided by it.
#pragma once

#include <optional>

#include "elaborate/name/names.h"

namespace rigor {

/// In base units, definitions put in; nothing where a letter is left, or where that is no real number.
[[nodiscard]] std::optional<double> approximate_value(const ExprTree& tree, const Names& names, ExprId expr);

}  // namespace rigor
