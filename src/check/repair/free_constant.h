// SPDX-License-Identifier: GPL-3.0-or-later
// A constant of integration is another number from one side to the next: `\sin^2x + C = -\cos^2x + C`, where
// the second C is the first one and 1, and `e^{kx + C} = Ce^{kx}`.
#pragma once

#include <optional>
#include <string>

#include "check/repair/repair.h"

namespace rigor {

class DecisionCache;

/// The letter, C, c or K, that is on both sides and absorbs a number or a factor: with one number for it
/// on the left and another one on the right the step is proved. Where numbers that differ are not needed, or
/// none of a few small ones do, nothing. It works on copies. Cost: a few decisions.
[[nodiscard]] std::optional<std::string> absorbing_constant(const ExprTree& tree, const Names& names,
                                                            const WrongStep& wrong,
                                                            DecisionCache* cache = nullptr);

}  // namespace rigor
