// SPDX-License-Identifier: GPL-3.0-or-later
// Chains with places that can be read in two ways.
#pragma once

#include "check/place/place.h"

namespace rigor {

/// Says both readings of the first such place.
[[nodiscard]] Diagnostic two_readings(const ParsedChain& parsed);
/// Without readings that are nonsense: if one is left, it is the only one; if none is, the first shows why.
ParsedChain sensible_readings(RowPlace& place, const ParsedChain& parsed);
/// Its verdict is the one that all readings have.
void decide_in_all_readings(RowPlace& place, const StepReading& row, const Claim& claim, Step& step);

}  // namespace rigor
