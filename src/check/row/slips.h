// SPDX-License-Identifier: GPL-3.0-or-later
// How the refuted rows of a chain hang together.
#pragma once

#include <span>

#include "check/place/place.h"

namespace rigor {

/// Says of each refuted step of a chain whether it is the first wrong one, what becomes of its slip, and
/// whether it only takes back an earlier one.
void explain_slips(RowPlace& place, const ParsedChain& parsed, ChainReading& reading, std::size_t first_step,
                   std::span<Step> steps);

}  // namespace rigor
