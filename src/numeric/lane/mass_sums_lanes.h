// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over points in lanes: see mass_sums.h. There are always 8 logical lanes: point k belongs to lane k mod
// 8, and fewer physical lanes pass over a block several times. The order of every sum is therefore fixed: in
// each lane of a block, chains of 8 terms, which a binary tree adds up; then the blocks, compensated; then
// the lanes.
#pragma once

#include "numeric/lane/double_double.h"
#include "numeric/lane/point_sums.h"

namespace rigor::RIGOR_INSTRUCTION_SET {

inline constexpr int logical_lanes = 8;
inline constexpr std::size_t chain_groups = 8;  // groups of 8 points that are added one after the other
inline constexpr std::size_t prefetch_points =
    256;  // measured: without it a sum takes 1.2 times the time of a read

/// x, y, z and m of one point in each lane.
struct PointLanes {
  Lanes of[4];
};

/// Asks for the memory some bytes after `at`, which may lie beyond the points: an address, never a pointer.
RIGOR_INLINE void prefetch_after(const double* at, std::size_t bytes) {
  __builtin_prefetch((const void*)((std::uintptr_t)at + bytes));
}

struct PointColumnLoader {
  PointPlaces points;
  RIGOR_INLINE PointLanes load_points(std::size_t first) const {
    PointLanes p;
    for (int i = 0; i < 4; ++i) {
      prefetch_after(points.at[i] + first, prefetch_points * sizeof(double));
      p.of[i] = load(points.at[i] + first);
    }
    return p;
  }
};

/// The columns of `lanes` rows of four numbers.
template <class V>
RIGOR_INLINE PointLanes columns_of_rows(const double* rows) {
  PointLanes p;
  if constexpr (lanes == 8) {
    const V a = load(rows);
    const V b = load(rows + 8);
    const V c = load(rows + 16);
    const V d = load(rows + 24);
    const V ab = __builtin_shufflevector(a, b, 0, 4, 8, 12, 1, 5, 9, 13);
    const V cd = __builtin_shufflevector(c, d, 0, 4, 8, 12, 1, 5, 9, 13);
    p.of[0] = __builtin_shufflevector(ab, cd, 0, 1, 2, 3, 8, 9, 10, 11);
    p.of[1] = __builtin_shufflevector(ab, cd, 4, 5, 6, 7, 12, 13, 14, 15);
    const V ef = __builtin_shufflevector(a, b, 2, 6, 10, 14, 3, 7, 11, 15);
    const V gh = __builtin_shufflevector(c, d, 2, 6, 10, 14, 3, 7, 11, 15);
    p.of[2] = __builtin_shufflevector(ef, gh, 0, 1, 2, 3, 8, 9, 10, 11);
    p.of[3] = __builtin_shufflevector(ef, gh, 4, 5, 6, 7, 12, 13, 14, 15);
  } else if constexpr (lanes == 4) {
    const V a = load(rows);
    const V b = load(rows + 4);
    const V c = load(rows + 8);
    const V d = load(rows + 12);
    const V ab = __builtin_shufflevector(a, b, 0, 4, 2, 6);
    const V cd = __builtin_shufflevector(c, d, 0, 4, 2, 6);
    p.of[0] = __builtin_shufflevector(ab, cd, 0, 1, 4, 5);
    p.of[2] = __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
    const V ef = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const V gh = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    p.of[1] = __builtin_shufflevector(ef, gh, 0, 1, 4, 5);
    p.of[3] = __builtin_shufflevector(ef, gh, 2, 3, 6, 7);
  } else {
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < lanes; ++k) p.of[i][k] = rows[4 * k + i];
  }
  return p;
}

struct PointRecordLoader {
  PointPlaces points;
  RIGOR_INLINE PointLanes load_points(std::size_t first) const {
    const double* const rows = points.at[0] + 4 * first;
    for (std::size_t k = 0; k < 4 * lanes; k += 8)
      prefetch_after(rows, (4 * prefetch_points + k) * sizeof(double));
    return columns_of_rows<Lanes>(rows);
  }
};

/// Up to 8 points, filled up with points of no mass at the centre, whose terms are 0.
struct LastPoints {
  double of[4][logical_lanes];
};

RIGOR_INLINE LastPoints last_points(const PointPlaces& points, std::size_t first, std::size_t count,
                                    const double (&centre)[3]) {
  LastPoints last;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t k = 0; k < logical_lanes; ++k)
      last.of[i][k] = k < count ? points.at[i][points.stride * (first + k)] : i < 3 ? centre[i] : 0;
  return last;
}

RIGOR_INLINE PointLanes load_last(const LastPoints& last, int part) {
  PointLanes p;
  for (int i = 0; i < 4; ++i) p.of[i] = load(last.of[i] + part * lanes);
  return p;
}

/// The terms of one point in each lane, or sums of them.
struct PointTerms {
  Lanes of[PointSums::count];
  LaneMask signs;

  RIGOR_INLINE void add(const PointTerms& other) {
#pragma GCC unroll 10
    for (int q = 0; q < PointSums::count; ++q) of[q] = of[q] + other.of[q];
    signs = signs | other.signs;
  }
};

/// 22 operations, 16 where there is a fused multiply-add. Error of a term of second order: 4 u (two
/// differences, two products).
struct PointTermsAbout {
  Lanes centre[3];

  /// m and m d, d = x − s, which is left in `d`.
  RIGOR_INLINE PointTerms first_moments(const PointLanes& p, Lanes (&d)[3]) const {
    PointTerms terms;
    terms.of[PointSums::mass] = p.of[3];
    terms.signs = (LaneMask)p.of[3];
#pragma GCC unroll 10
    for (int i = 0; i < 3; ++i) {
      d[i] = p.of[i] - centre[i];
      terms.of[PointSums::first + i] = p.of[3] * d[i];
    }
    return terms;
  }

  RIGOR_INLINE PointTerms operator()(const PointLanes& p) const {
    Lanes d[3];
    PointTerms terms = first_moments(p, d);
#pragma GCC unroll 10
    for (int i = 0; i < 3; ++i) {
      terms.of[PointSums::square + i] = terms.of[PointSums::first + i] * d[i];
      terms.of[PointSums::product + i] = terms.of[PointSums::first + (i + 1) % 3] * d[(i + 2) % 3];
    }
    return terms;
  }

  RIGOR_INLINE void add_to(PointTerms& sums, const PointLanes& p) const {
    Lanes d[3];
    const PointTerms terms = first_moments(p, d);
    const Lanes* const md = terms.of + PointSums::first;
    sums.of[PointSums::mass] = sums.of[PointSums::mass] + terms.of[PointSums::mass];
    sums.signs = sums.signs | terms.signs;
#pragma GCC unroll 10
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      const int k = (i + 2) % 3;
      sums.of[PointSums::first + i] = sums.of[PointSums::first + i] + md[i];
      sums.of[PointSums::square + i] = product_plus(md[i], d[i], sums.of[PointSums::square + i]);
      sums.of[PointSums::product + i] = product_plus(md[j], d[k], sums.of[PointSums::product + i]);
    }
  }
};

/// A chain of up to 8 groups from `first` on.
template <class Loader>
RIGOR_INLINE PointTerms chain_of(const Loader& loader, std::size_t first, std::size_t groups,
                                 const PointTermsAbout& terms_of) {
  PointTerms sum = terms_of(loader.load_points(first));
#pragma GCC unroll 1  // measured: unrolled, sums go to memory
  for (std::size_t g = 1; g < groups; ++g)
    terms_of.add_to(sum, loader.load_points(first + logical_lanes * g));
  return sum;
}

/// The sums over a block's points in one set of physical lanes: the chains as a binary tree, by a counter
/// whose bits say which levels wait.
template <class Loader>
RIGOR_INLINE PointTerms block_of(const Loader& loader, std::size_t first, std::size_t groups, bool has_last,
                                 const LastPoints& last, int part, const PointTermsAbout& terms_of) {
  PointTerms waiting[4];
  std::size_t chains = 0;
  const std::size_t all_groups = groups + (has_last ? 1 : 0);
  for (std::size_t done = 0; done < all_groups; done += chain_groups) {
    PointTerms sum;
    const std::size_t full = groups - done < chain_groups ? groups - done : chain_groups;
    if (full == 0) {
      sum = terms_of(load_last(last, part));
    } else {
      const std::size_t at = first + logical_lanes * done + static_cast<std::size_t>(part * lanes);
      sum = full == chain_groups ? chain_of(loader, at, chain_groups, terms_of)
                                 : chain_of(loader, at, full, terms_of);
      if (full < chain_groups && has_last) terms_of.add_to(sum, load_last(last, part));
    }
    std::size_t level = 0;
    for (std::size_t bits = chains; (bits & 1U) != 0; bits >>= 1U) sum.add(waiting[level++]);
    waiting[level] = sum;
    ++chains;
  }
  std::size_t level = 0;
  while (((chains >> level) & 1U) == 0) ++level;
  PointTerms sum = waiting[level];
  for (++level; (chains >> level) != 0; ++level)
    if (((chains >> level) & 1U) != 0) sum.add(waiting[level]);
  return sum;
}

/// Sums of the physical lanes of all parts.
struct LaneSums {
  double high[PointSums::count][logical_lanes];
  double low[PointSums::count][logical_lanes];
};

/// Two lanes, which every instruction set has.
using LanePair = double __attribute__((vector_size(2 * sizeof(double))));

RIGOR_INLINE LanePair load_pair(const double* from) {
  LanePair x;
  __builtin_memcpy(&x, from, sizeof x);
  return x;
}

/// a + b, each high + low, to 2 v.
template <class T>
RIGOR_INLINE DoubleDouble<T> compensated_sum(DoubleDouble<T> a, DoubleDouble<T> b) {
  const DoubleDouble<T> high = exact_sum(a.high, b.high);
  return {high.high, (a.low + b.low) + high.low};
}

/// The lanes as a binary tree: first lane k with lane k + 4.
RIGOR_INLINE void combine_lanes(const LaneSums& of_lanes, PointSums& sums) {
#pragma GCC unroll 10
  for (int q = 0; q < PointSums::count; ++q) {
    DoubleDouble<LanePair> pair[4];
    for (int k = 0; k < 4; ++k)
      pair[k] = {load_pair(of_lanes.high[q] + 2 * k), load_pair(of_lanes.low[q] + 2 * k)};
    const DoubleDouble<LanePair> all_pairs =
        compensated_sum(compensated_sum(pair[0], pair[2]), compensated_sum(pair[1], pair[3]));
    const DoubleDouble<double> sum =
        compensated_sum(DoubleDouble<double>{all_pairs.high[0], all_pairs.low[0]},
                        DoubleDouble<double>{all_pairs.high[1], all_pairs.low[1]});
    const DoubleDouble<double> value = normalised(sum.high, sum.low);
    sums.high[q] = value.high;
    sums.low[q] = value.low;
  }
}

template <class Loader>
RIGOR_INLINE void sum_points_of(const Loader& loader, std::size_t count, const double (&high)[3],
                                PointSums& sums) {
  LaneSums of_lanes = {};
  PointTermsAbout terms_of;
  for (int i = 0; i < 3; ++i) terms_of.centre[i] = all<Lanes>(high[i]);
  LaneMask signs = {};
  const LastPoints last =
      last_points(loader.points, count - count % logical_lanes, count % logical_lanes, high);
  for (std::size_t first = 0; first < count; first += block_points) {
    const std::size_t points = count - first < block_points ? count - first : block_points;
    for (int part = 0; part < logical_lanes / lanes; ++part) {
      const PointTerms block =
          points == block_points  // as a rule: with constants
              ? block_of(loader, first, block_points / logical_lanes, false, last, part, terms_of)
              : block_of(loader, first, points / logical_lanes, points % logical_lanes != 0, last, part,
                         terms_of);
      for (int q = 0; q < PointSums::count; ++q) {
        double* const h = of_lanes.high[q] + part * lanes;
        double* const l = of_lanes.low[q] + part * lanes;
        CompensatedSum<Lanes> sum{load(h), load(l)};
        sum.add(block.of[q]);
        store(h, sum.high);
        store(l, sum.low);
      }
      signs = signs | block.signs;
    }
  }
  combine_lanes(of_lanes, sums);
  sums.has_sign = any(signs & INT64_MIN);
}

static void sum_points(const PointPlaces& points, std::size_t count, const double (&high)[3],
                       const double (&)[3], PointSums& sums) {
  if (points.stride == 1)
    sum_points_of(PointColumnLoader{points}, count, high, sums);
  else
    sum_points_of(PointRecordLoader{points}, count, high, sums);
}

template <class Loader>
RIGOR_INLINE void sample_points_of(const Loader& loader, std::size_t groups, std::size_t step,
                                   const double (&from)[3], double (&sums)[4][8]) {
  for (int part = 0; part < logical_lanes / lanes; ++part) {
    Lanes origin[3];
    for (int i = 0; i < 3; ++i) origin[i] = all<Lanes>(from[i]);
    Lanes sum[4] = {};
    for (std::size_t g = 0; g < groups; ++g) {
      const PointLanes p = loader.load_points(g * step + static_cast<std::size_t>(part * lanes));
      for (int i = 0; i < 3; ++i) sum[i] = sum[i] + p.of[3] * (p.of[i] - origin[i]);
      sum[3] = sum[3] + p.of[3];
    }
    for (int i = 0; i < 4; ++i) store(sums[i] + part * lanes, sum[i]);
  }
}

static void sample_points(const PointPlaces& points, std::size_t groups, std::size_t step,
                          const double (&origin)[3], double (&sums)[4][8]) {
  if (points.stride == 1)
    sample_points_of(PointColumnLoader{points}, groups, step, origin, sums);
  else
    sample_points_of(PointRecordLoader{points}, groups, step, origin, sums);
}

}  // namespace rigor::RIGOR_INSTRUCTION_SET
