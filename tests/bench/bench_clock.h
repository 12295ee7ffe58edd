// SPDX-License-Identifier: GPL-3.0-or-later
// The clock of all benchmarks. A measurement takes 10 us at least, so that reading the clock, some 30 ns,
// does not count.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <limits>

namespace rigor {

/// Of one of `repeats` runs in a row.
template <class Run>
[[nodiscard]] double nanoseconds_of(const Run& run, std::size_t repeats) {
  using Clock = std::chrono::steady_clock;
  const auto before = Clock::now();
  for (std::size_t k = 0; k < repeats; ++k) run();
  return std::chrono::duration<double, std::nano>(Clock::now() - before).count() /
         static_cast<double>(repeats);
}

/// The least power of two of runs that take 10 us.
template <class Run>
[[nodiscard]] std::size_t repeats_of(const Run& run) {
  std::size_t repeats = 1;
  while (nanoseconds_of(run, repeats) * static_cast<double>(repeats) < 1e4) repeats *= 2;
  return repeats;
}

/// The least time of a run over 40 ms of measurements, and three at least.
template <class Run>
[[nodiscard]] double least_nanoseconds(const Run& run) {
  using Clock = std::chrono::steady_clock;
  const std::size_t repeats = repeats_of(run);
  double least = std::numeric_limits<double>::infinity();
  const auto start = Clock::now();
  for (int round = 0; round < 3 || Clock::now() - start < std::chrono::milliseconds(40); ++round)
    least = std::min(least, nanoseconds_of(run, repeats));
  return least;
}

}  // namespace rigor
