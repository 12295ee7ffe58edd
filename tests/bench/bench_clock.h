// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <limits>

namespace rigor {

/// The least time of a run in 40 ms of them, and of three at least; in nanoseconds.
template <class Run>
[[nodiscard]] double least_nanoseconds(const Run& run) {
  using Clock = std::chrono::steady_clock;
  double least = std::numeric_limits<double>::infinity();
  const auto start = Clock::now();
  for (int round = 0; round < 3 || Clock::now() - start < std::chrono::milliseconds(40); ++round) {
    const auto before = Clock::now();
    run();
    least = std::min(least, std::chrono::duration<double, std::nano>(Clock::now() - before).count());
  }
  return least;
}

}  // namespace rigor
