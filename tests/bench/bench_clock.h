// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <limits>

namespace rigor {

/// The least time of `rounds` runs, in nanoseconds.
template <class Run>
[[nodiscard]] double least_nanoseconds(int rounds, const Run& run) {
  double least = std::numeric_limits<double>::infinity();
  for (int round = 0; round < rounds; ++round) {
    const auto before = std::chrono::steady_clock::now();
    run();
    least = std::min(
        least, std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - before).count());
  }
  return least;
}

}  // namespace rigor
