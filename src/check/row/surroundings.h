// SPDX-License-Identifier: GPL-3.0-or-later
// What is said around a row, and what that leaves of its verdict.
#pragma once

#include "check/place/place.h"

namespace rigor {

/// "or" stands beside it, on its line or in the prose between two displays.
bool is_alternative(const RowPlace& place, const ParsedChain& parsed);
/// `a > 0, \quad \sqrt{a^2} = a`: orders of letters on the line of an equation say when it holds.
std::vector<const ParsedChain*> conditions_beside(const RowPlace& place, const ParsedChain& parsed);
bool is_condition_beside(const RowPlace& place, const ParsedChain& parsed);
Standpoint standpoint(RowPlace& place, const ParsedChain& parsed);
/// A refutation that rests on what is not said for this place is taken back; laws are kept for later.
void heed_surroundings(RowPlace& place, const StepReading& row, const Claim& claim, Judgement& judgement);

}  // namespace rigor
