// SPDX-License-Identifier: GPL-3.0-or-later
// `a = F/m` says what `F = ma` says only if m is not 0, so it is a result; `-F = -ma` says it again.
#pragma once

#include "expr/statement/statement.h"

namespace rigor {

class DecisionCache;

/// Are the claim's sides those of the law, perhaps exchanged, each times one number, for all values of their
/// letters? `1 - a = 1 - b` says more than that it restates `a = b`: it follows from that. Equations with
/// free indices or particles are not compared.
[[nodiscard]] bool restates(ExprTree& tree, const Equation& claim, const Equation& law, DecisionCache* cache);

}  // namespace rigor
