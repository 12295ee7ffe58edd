// SPDX-License-Identifier: GPL-3.0-or-later
// What a number is worth, roughly: to be shown beside a number that is wrong, or to doubt that it is.
#pragma once

#include <optional>

#include "check/doubt/digits.h"

namespace rigor {

/// In base units, definitions put in; nothing where a letter is left, or where that is no real number.
[[nodiscard]] std::optional<double> approximate_value(const ExprTree& tree, const Names& names, ExprId expr);

/// `1.011/0.723 = 1.39862`, without units: it differs by less than half a percent from what the decimals
/// give, which may have had more digits.
[[nodiscard]] bool may_be_rounded_on_the_way(const ExprTree& tree, const Names& names, const Claim& claim,
                                             const DigitComparison& compared);

}  // namespace rigor
