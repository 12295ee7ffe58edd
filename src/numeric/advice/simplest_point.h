// SPDX-License-Identifier: GPL-3.0-or-later
// A point with few digits that shows the same: for people to read and to type.
#pragma once

#include "numeric/advice/attack.h"

namespace rigor {

/// Where the form loses at least three quarters of the digits that it loses at `found`.
[[nodiscard]] LosingPoint simplest_point(Attacker& attacker, const SearchSpace& space, std::size_t form,
                                         const Range& range, const LosingPoint& found);

}  // namespace rigor
