// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over point masses, as the lane kernels of mass_sums_lanes.h give them. Plain arrays: this is read
// where no inline function of a library may be.
#pragma once

#include <cstddef>

namespace rigor {

/// Coordinate i of point k at `at[i][stride k]`, its mass at `at[3][stride k]`. Any alignment.
struct PointPlaces {
  const double* at[4] = {};
  std::size_t stride = 1;  // 1: four columns; 4: records x, y, z, m
};

/// Each as high + low, for d = x − s: Σ m, Σ m d_i, Σ m d_i², Σ m d_j d_k by the axis i that is left out.
struct PointSums {
  static constexpr int mass = 0;
  static constexpr int first = 1;
  static constexpr int square = 4;
  static constexpr int product = 7;
  static constexpr int count = 10;
  double high[count] = {};
  double low[count] = {};
  bool has_sign = false;  // a mass is negative, or −0
  bool is_wide = false;   // sharp sums: a coordinate or a mass exceeds `widest_of_sharp_sums`
};

/// Beyond it, products may not be exact on machines without a fused multiply-add.
inline constexpr double widest_of_sharp_sums = 0x1p900;

/// Points are summed in blocks, each about half of the first cache, and the blocks of a chunk one after the
/// other; chunks are what threads share.
inline constexpr std::size_t block_points = 512;
inline constexpr std::size_t chunk_points = 16 * block_points;

/// Sums over `count` ≤ chunk_points points about `centre`: high parts and low parts of s.
using SumPoints = void (*)(const PointPlaces& points, std::size_t count, const double (&high)[3],
                           const double (&low)[3], PointSums& sums);

/// Σ m (x_i − origin_i) and Σ m over `groups` groups of 8 points, `step` points apart, for each place in the
/// group.
using SamplePoints = void (*)(const PointPlaces& points, std::size_t groups, std::size_t step,
                              const double (&origin)[3], double (&sums)[4][8]);

}  // namespace rigor
