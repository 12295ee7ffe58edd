// SPDX-License-Identifier: GPL-3.0-or-later
// A number to about 106 bits: high + low, |low| ≤ ½ unit in the last place of high.
#pragma once

#include <array>

namespace rigor {

struct HighLow {
  double high = 0;
  double low = 0;
};
using SharpPosition = std::array<HighLow, 3>;
using SharpTensor = std::array<SharpPosition, 3>;  // symmetric

}  // namespace rigor
