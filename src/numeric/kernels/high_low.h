// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace rigor {

/// A number to about 106 bits: high + low, |low| ≤ ½ unit in the last place of high.
struct HighLow {
  double high = 0;
  double low = 0;
};

using SharpPosition = std::array<HighLow, 3>;
using SharpTensor = std::array<SharpPosition, 3>;

}  // namespace rigor
