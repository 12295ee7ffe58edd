// SPDX-License-Identifier: GPL-3.0-or-later
// How much longer something takes when there is four times as much of it: about 4 where it is linear, 16
// where it is quadratic. Both are measured in one run, so that the machine does not matter.
#pragma once

#include <algorithm>
#include <ctime>
#include <functional>

namespace rigor {

/// Processor time of `work(4 * count)` over that of `work(count)`, each the best of three.
inline double growth_by_four(int count, const std::function<void(int)>& work) {
  const auto best = [&](int size) {
    std::clock_t least = 0;
    for (int run = 0; run < 3; ++run) {
      const std::clock_t start = std::clock();
      work(size);
      const std::clock_t taken = std::clock() - start;
      least = run == 0 ? taken : std::min(least, taken);
    }
    return static_cast<double>(std::max<std::clock_t>(least, 1));
  };
  return best(4 * count) / best(count);
}

/// Between linear and quadratic.
inline constexpr double linear_by_four = 8;

}  // namespace rigor
