// SPDX-License-Identifier: GPL-3.0-or-later
// What a refuted row may mean if it is not an identity.
#pragma once

#include "check/place/place.h"

namespace rigor {

/// A message and its help if the step may not be meant for all values; nothing if it is true with another
/// sign, factor or letter, since a slip is likelier.
[[nodiscard]] std::optional<std::pair<std::string, std::string>> doubt_left(RowPlace& place,
                                                                            const StepReading& row,
                                                                            const Claim& claim);

}  // namespace rigor
