// SPDX-License-Identifier: GPL-3.0-or-later
// A row with places that can be read in two ways: `\cos\omega(t - t_0)`.
#pragma once

#include "check/directive/directive.h"
#include "check/step/report.h"

namespace rigor {

/// Says both readings of the first such place.
[[nodiscard]] Diagnostic two_readings(const ParsedChain& parsed);

}  // namespace rigor
