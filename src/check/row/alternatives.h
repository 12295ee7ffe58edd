// SPDX-License-Identifier: GPL-3.0-or-later
// `a = 0 or b = 0`: one of several equations holds. It is proved if the product of all differences is 0.
#pragma once

#include "check/place/place.h"

namespace rigor {

bool proves_alternatives(RowPlace& place, const ParsedChain& parsed, Step& step);

}  // namespace rigor
