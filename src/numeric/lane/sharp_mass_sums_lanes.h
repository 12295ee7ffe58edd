// SPDX-License-Identifier: GPL-3.0-or-later
// The sums of mass_sums_lanes.h in double-double: differences exact, products and sums to about 2^-100.
#pragma once

#include "numeric/lane/mass_sums_lanes.h"

namespace rigor::RIGOR_INSTRUCTION_SET {

/// The compensated sums of one block in one set of physical lanes, with the greatest coordinate and mass.
struct SharpTerms {
  CompensatedSum<Lanes> of[PointSums::count];
  Lanes greatest;
  LaneMask signs;
};

/// m d, not normalised: high + low with |low| ≤ 3 u |high|. Error: 3 v.
RIGOR_INLINE DoubleDouble<Lanes> weighted(Lanes m, DoubleDouble<Lanes> d) {
  const DoubleDouble<Lanes> p = exact_product(m, d.high);
  return {p.high, p.low + m * d.low};
}

/// 152 operations with a fused multiply-add, 12 more where the centre has a low part. That is at most half a
/// unit in the last place of its high part, and a high part of a difference is 0 or at least as much.
template <bool has_low>
RIGOR_INLINE void add_sharply(SharpTerms& sums, const PointLanes& p, const Lanes (&high)[3],
                              const Lanes (&low)[3]) {
  const Lanes m = p.of[3];
  DoubleDouble<Lanes> d[3];
  DoubleDouble<Lanes> md[3];
#pragma GCC unroll 4
  for (int i = 0; i < 3; ++i) {
    d[i] = exact_difference(p.of[i], high[i]);
    if constexpr (has_low) d[i] = normalised(d[i].high, d[i].low - low[i]);
  }
  sums.signs = sums.signs | (LaneMask)m;
#pragma GCC unroll 4
  for (int i = 0; i < 4; ++i) sums.greatest = greater(absolute(p.of[i]), sums.greatest);
  sums.of[PointSums::mass].add(m);
#pragma GCC unroll 4
  for (int i = 0; i < 3; ++i) {
    md[i] = weighted(m, d[i]);
    sums.of[PointSums::first + i].add(md[i]);
  }
#pragma GCC unroll 4
  for (int i = 0; i < 3; ++i) {
    sums.of[PointSums::square + i].add_product(md[i], d[i]);
    sums.of[PointSums::product + i].add_product(md[(i + 1) % 3], d[(i + 2) % 3]);
  }
}

template <bool has_low, class Loader>
RIGOR_INLINE void sum_sharply_of(const Loader& loader, std::size_t count, const double (&high)[3],
                                 const double (&low)[3], PointSums& sums) {
  LaneSums of_lanes = {};
  Lanes centre_high[3];
  Lanes centre_low[3];
  for (int i = 0; i < 3; ++i) {
    centre_high[i] = all<Lanes>(high[i]);
    centre_low[i] = all<Lanes>(low[i]);
  }
  SharpTerms block;
  block.greatest = Lanes{};
  block.signs = LaneMask{};
  const LastPoints last =
      last_points(loader.points, count - count % logical_lanes, count % logical_lanes, high);
  for (std::size_t first = 0; first < count; first += block_points) {
    const std::size_t points = count - first < block_points ? count - first : block_points;
    for (int part = 0; part < logical_lanes / lanes; ++part) {
      for (int q = 0; q < PointSums::count; ++q) block.of[q] = {};
      for (std::size_t g = 0; g < points / logical_lanes; ++g)
        add_sharply<has_low>(
            block, loader.load_points(first + logical_lanes * g + static_cast<std::size_t>(part * lanes)),
            centre_high, centre_low);
      if (points % logical_lanes != 0)
        add_sharply<has_low>(block, load_last(last, part), centre_high, centre_low);
      for (int q = 0; q < PointSums::count; ++q) {
        double* const h = of_lanes.high[q] + part * lanes;
        double* const l = of_lanes.low[q] + part * lanes;
        const DoubleDouble<Lanes> sum = DoubleDouble<Lanes>{load(h), load(l)} + block.of[q].value();
        store(h, sum.high);
        store(l, sum.low);
      }
    }
  }
  combine_lanes(of_lanes, sums);
  sums.has_sign = any(block.signs & INT64_MIN);
  sums.is_wide = any(!(block.greatest <= widest_of_sharp_sums));
}

static void sum_points_sharply(const PointPlaces& points, std::size_t count, const double (&high)[3],
                               const double (&low)[3], PointSums& sums) {
  const bool has_low = low[0] != 0 || low[1] != 0 || low[2] != 0;
  if (points.stride != 1 && has_low)
    sum_sharply_of<true>(PointRecordLoader{points}, count, high, low, sums);
  else if (points.stride != 1)
    sum_sharply_of<false>(PointRecordLoader{points}, count, high, low, sums);
  else if (has_low)
    sum_sharply_of<true>(PointColumnLoader{points}, count, high, low, sums);
  else
    sum_sharply_of<false>(PointColumnLoader{points}, count, high, low, sums);
}

}  // namespace rigor::RIGOR_INSTRUCTION_SET
