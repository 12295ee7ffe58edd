// SPDX-License-Identifier: GPL-3.0-or-later
// `a = F/m` says what `F = ma` says only if m is not 0, so it is a result; `-F = -ma` says it again.
#pragma once

#include "expr/statement/statement.h"

namespace rigor {

class DecisionCache;

/// Is the difference of the claim's sides a multiple of that of the law, by a number, for all values of their
/// letters? Equations with free indices or particles are not compared.
[[nodiscard]] bool restates(ExprTree& tree, const Equation& claim, const Equation& law, DecisionCache* cache);

}  // namespace rigor
