// SPDX-License-Identifier: GPL-3.0-or-later
// `e^x = 1 + x + O(x^2)`: sides that are compared as power series.
#pragma once

#include "check/place/place.h"

namespace rigor {

/// `+ O(x^n)` ends the right side.
[[nodiscard]] bool is_up_to_order(const StepReading& row);
void decide_up_to_order(RowPlace& place, const StepReading& row, Step& step);

}  // namespace rigor
