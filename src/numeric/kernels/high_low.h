// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "numeric/lane/double_double.h"

namespace rigor {

/// A number to about 106 bits: high + low, |low| ≤ ½ unit in the last place of high.
using HighLow = baseline::DoubleDouble<double>;

using SharpPosition = std::array<HighLow, 3>;
using SharpTensor = std::array<SharpPosition, 3>;

}  // namespace rigor
