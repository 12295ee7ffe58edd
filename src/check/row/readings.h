// SPDX-License-Identifier: GPL-3.0-or-later
// Chains with places that can be read in two ways. All readings are decided, and only a verdict that all
// share counts.
#pragma once

#include "check/place/place.h"

namespace rigor {

/// Names both readings of the first such place.
[[nodiscard]] Diagnostic two_readings(const ParsedChain& parsed);
/// Without readings that are nonsense: if one is left, it is the only one; if none is, the first shows why.
ParsedChain sensible_readings(RowPlace& place, const ParsedChain& parsed);
/// The verdict is the one that all readings have in common, if there is one.
void decide_in_all_readings(RowPlace& place, const StepReading& row, const Claim& claim, Step& step);

}  // namespace rigor
