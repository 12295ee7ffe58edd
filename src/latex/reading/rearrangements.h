// SPDX-License-Identifier: GPL-3.0-or-later
// Rewritings of one side that change how its parts stand to each other: factors in another order, rows for
// columns, the argument of a function twice or half as large, an exponent one more or less, a root; or which
// letter is held.
#pragma once

#include <vector>

#include "latex/reading/rewritings.h"

namespace rigor {

[[nodiscard]] std::vector<Rewriting> rearrangements_of(TokenView side, const std::vector<TokenView>& chain);

}  // namespace rigor
