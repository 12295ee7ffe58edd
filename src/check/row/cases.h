// SPDX-License-Identifier: GPL-3.0-or-later
// Definitions that hold for a case only, at another place, or until their letter gets another meaning.
#pragma once

#include "check/place/place.h"

namespace rigor {

/// Do words of its sentence limit the display at hand to a case?
bool is_conditional(const RowPlace& place);
/// Is its heading about a special case: "Electrostatics", "In vacuum"?
bool is_of_a_case(const RowPlace& place);
/// Takes a proof back that rests on a definition for another case, or on one that has been replaced since.
void heed_proof(RowPlace& place, const ParsedChain& parsed, const Claim& claim, Judgement& judgement);

}  // namespace rigor
