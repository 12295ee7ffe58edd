// SPDX-License-Identifier: GPL-3.0-or-later
// Constants that are written where units stand: `938\,\mathrm{MeV}/c^2`, `1.008\,\mathrm u`, and an inverse
// number, `\frac{1}{137}`.
#pragma once

#include "check/verdict/judge.h"

namespace rigor {

/// The same claim with these on the other side, so that a number with units of measure is left; any other
/// claim as it is.
[[nodiscard]] Claim with_plain_number(ExprTree& tree, const Claim& claim);

}  // namespace rigor
