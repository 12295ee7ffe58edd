// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace rigor {

/// A number that no two doubles hold: Σ parts / Σ divisor to within `error`. Rational where that is 0.
struct LongNumber {
  std::vector<double> parts;
  std::vector<double> divisor{1};
  double error = 0;
};

}  // namespace rigor
