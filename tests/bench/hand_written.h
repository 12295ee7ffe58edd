// SPDX-License-Identifier: GPL-3.0-or-later
// What a programmer would write for the formulas of `program_bench.cpp`, compiled with the flags of the floor
// `numeric`. Vectors are a structure of arrays: one pointer for each component.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace rigor::bench {

using Columns = std::array<const double*, 3>;

struct PointMasses {
  const double* m = nullptr;
  Columns r{};
  std::size_t count = 0;
};

struct HandWritten {
  void (*cross_square)(const Columns& a, const Columns& b, std::size_t samples, double* result);
  void (*dot_squares)(const Columns& a, const Columns& b, std::size_t samples, double* result);
  void (*energy_from_speed)(const PointMasses& body, const Columns& w, std::size_t samples, double* result);
  void (*energy_from_distance)(const PointMasses& body, const Columns& w, std::size_t samples,
                               double* result);
  void (*energy_from_inertia)(const PointMasses& body, const Columns& w, std::size_t samples, double* result);
  void (*angular_momentum)(const PointMasses& body, const Columns& w, std::size_t samples,
                           const std::array<double*, 3>& result);
  void (*euler_rates)(const std::array<double, 3>& moments, const Columns& w, std::size_t samples,
                      const std::array<double*, 3>& result);
};

/// Compiled for all that this machine has.
namespace native {
extern const HandWritten loops;
}

/// Compiled for an instruction set by its name, as a machine with no more would have them.
[[nodiscard]] const HandWritten& loops_for(std::string_view instruction_set);

}  // namespace rigor::bench
