// SPDX-License-Identifier: GPL-3.0-or-later
// `\sqrt{19} = 4.3`: numbers that no sample gives exactly are compared by rational bounds.
#pragma once

#include "check/place/place.h"

namespace rigor {

void refute_by_digits(RowPlace& place, const ParsedChain& parsed, const Claim& claim, Judgement& judgement);
/// A recorded refutation by bounds has no sample to put in, so the bounds are computed again.
bool replay_by_digits(RowPlace& place, const Claim& claim, Step& step);

}  // namespace rigor
