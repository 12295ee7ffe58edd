// SPDX-License-Identifier: GPL-3.0-or-later
// The words and conditions around a row, and what they leave of its verdict.
#pragma once

#include "check/place/place.h"

namespace rigor {

/// Is there an "or" next to it, on its line or in the prose between two displays?
bool is_alternative(const RowPlace& place, const ParsedChain& parsed);
/// `a > 0, \quad \sqrt{a^2} = a`: orders of letters on the line of an equation say when it holds.
std::vector<const ParsedChain*> conditions_beside(const RowPlace& place, const ParsedChain& parsed);
bool is_condition_beside(const RowPlace& place, const ParsedChain& parsed);
Standpoint standpoint(RowPlace& place, const ParsedChain& parsed);
/// Takes a refutation back that rests on something not said for this place; keeps laws for later rows.
void heed_surroundings(RowPlace& place, const StepReading& row, const Claim& claim, Judgement& judgement);

}  // namespace rigor
