// SPDX-License-Identifier: GPL-3.0-or-later
// What else a refuted row may mean.
#pragma once

#include "check/place/place.h"

namespace rigor {

/// A message and its help, where the step may not be meant for all values. Where it is also true with another
/// sign, factor or letter, that is likelier.
[[nodiscard]] std::optional<std::pair<std::string, std::string>> doubt_left(RowPlace& place,
                                                                            const StepReading& row,
                                                                            const Claim& claim);

}  // namespace rigor
