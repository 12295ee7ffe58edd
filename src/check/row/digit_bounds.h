// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that no sample gives exactly, compared by bounds.
#pragma once

#include "check/place/place.h"

namespace rigor {

void refute_by_digits(RowPlace& place, const ParsedChain& parsed, const Claim& claim, Judgement& judgement);
/// There is no sample to be put in: the bounds are found again.
bool replay_by_digits(RowPlace& place, const Claim& claim, Step& step);

}  // namespace rigor
