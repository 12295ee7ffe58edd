// SPDX-License-Identifier: GPL-3.0-or-later
// Roots by the signs of their letters. `2\sqrt{a/2b}\,\sqrt{b/2a} = 1` holds for a, b > 0 and for a, b < 0,
// where the radicands are 0 or more, and elsewhere there is nothing to say: √(R²) is R in the one case and −R
// in the other, and only together they are all.
#pragma once

#include <vector>

#include "algebra/engine/attempt.h"
#include "algebra/point/scope.h"

namespace rigor {

/// All choices of signs for the letters under roots that are divided by, and so are not 0. Empty: there are
/// none, or too many of them.
[[nodiscard]] std::vector<std::vector<KnownSign>> sign_cases(const Scope& scope, const Attempt& attempt);

}  // namespace rigor
