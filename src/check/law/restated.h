// SPDX-License-Identifier: GPL-3.0-or-later
// `a = F/m` says what `F = ma` says only if m is not 0, so it is a result; `-F = -ma` says it again.
#pragma once

#include <optional>

#include "expr/statement/statement.h"

namespace rigor {

class DecisionCache;

/// Where the claim's sides differ; nothing if it cannot be compared with laws: it holds, or has free indices
/// or particles.
[[nodiscard]] std::optional<Sample> where_it_fails(const ExprTree& tree, const Equation& claim,
                                                   DecisionCache* cache);

/// Are the claim's sides those of the law, perhaps exchanged, each times one number, for all values of their
/// letters? `1 - a = 1 - b` says more than that it restates `a = b`: it follows from that. Equations with
/// free indices or particles are not compared. `fails`: where the claim does; it is found once for all laws.
[[nodiscard]] bool restates(ExprTree& tree, const Equation& claim, const Sample& fails, const Equation& law,
                            DecisionCache* cache);

}  // namespace rigor
