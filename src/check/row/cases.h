// SPDX-License-Identifier: GPL-3.0-or-later
// What a definition is said for: a case, another place, or until its letter gets another meaning.
#pragma once

#include "check/place/place.h"

namespace rigor {

/// What its sentence says may make a case of the display at hand.
bool is_conditional(const RowPlace& place);
/// Its heading is about a special case: "Electrostatics", "In vacuum".
bool is_of_a_case(const RowPlace& place);
/// A proof that rests on what is said for another case, or is said anew since, is taken back.
void heed_proof(RowPlace& place, const ParsedChain& parsed, const Claim& claim, Judgement& judgement);

}  // namespace rigor
