// SPDX-License-Identifier: GPL-3.0-or-later
// Sums over the triangles of a mesh, in eight logical lanes: the triangle n goes to lane n mod 8. A machine
// with narrower registers passes over the mesh several times, each for its share of the lanes, and adds up
// the same numbers in the same order.
#pragma once

#include <cstdint>

#include "numeric/lane/double_double.h"
#include "numeric/lane/mesh_pack_lanes.h"
#include "numeric/lane/mesh_totals.h"

namespace rigor::RIGOR_INSTRUCTION_SET {

inline constexpr std::size_t mesh_lanes = 8;

struct MeshCorners {
  Lanes at[3][3];  // corner, coordinate
};

/// x, y and z of the vertices; each lane takes one.
RIGOR_INLINE void load_vertices(const double* packed, const std::uint32_t (&vertices)[lanes],
                                Lanes (&xyz)[3]) {
#if RIGOR_LANES == 8
  Lanes even[2];  // x x z z of two pairs of vertices
  Lanes odd[2];   // y y and the fourth
  for (int half = 0; half < 2; ++half) {
    MeshVertex v[4];
    for (int n = 0; n < 4; ++n) __builtin_memcpy(&v[n], packed + 4 * std::size_t{vertices[4 * half + n]}, 32);
    const Lanes first = __builtin_shufflevector(v[0], v[2], 0, 1, 2, 3, 4, 5, 6, 7);
    const Lanes second = __builtin_shufflevector(v[1], v[3], 0, 1, 2, 3, 4, 5, 6, 7);
    even[half] = __builtin_shufflevector(first, second, 0, 8, 2, 10, 4, 12, 6, 14);
    odd[half] = __builtin_shufflevector(first, second, 1, 9, 3, 11, 5, 13, 7, 15);
  }
  xyz[0] = __builtin_shufflevector(even[0], even[1], 0, 1, 4, 5, 8, 9, 12, 13);
  xyz[1] = __builtin_shufflevector(odd[0], odd[1], 0, 1, 4, 5, 8, 9, 12, 13);
  xyz[2] = __builtin_shufflevector(even[0], even[1], 2, 3, 6, 7, 10, 11, 14, 15);
#else
  for (int i = 0; i < 3; ++i)
    for (int lane = 0; lane < lanes; ++lane) xyz[i][lane] = packed[4 * std::size_t{vertices[lane]} + i];
#endif
}

/// The triangles from `corners` on; each lane takes one.
RIGOR_INLINE MeshCorners load_corners(const double* packed, const std::uint32_t* corners) {
  MeshCorners c;
  for (int corner = 0; corner < 3; ++corner) {
    std::uint32_t vertices[lanes];
    for (int lane = 0; lane < lanes; ++lane) vertices[lane] = corners[3 * lane + corner];
    load_vertices(packed, vertices, c.at[corner]);
  }
  return c;
}

/// a · (b × c). Error: 2^-99 for coordinates of at most 1 in size. All products of two numbers are exact;
/// what is rounded are a dozen low parts, each below 2^-49 and so with 2^-103 at most. 63 operations.
RIGOR_INLINE DoubleDouble<Lanes> six_volumes(const MeshCorners& corners) {
  const Lanes* const a = corners.at[0];
  const Lanes* const b = corners.at[1];
  const Lanes* const c = corners.at[2];
  CompensatedSum<Lanes> sum;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    const DoubleDouble<Lanes> bc = exact_product(b[j], c[k]);
    const DoubleDouble<Lanes> cb = exact_product(b[k], c[j]);
    DoubleDouble<Lanes> area = exact_difference(bc.high, cb.high);
    area.low = area.low + (bc.low - cb.low);
    const DoubleDouble<Lanes> term = exact_product(a[i], area.high);
    if (i == 0)
      sum.high = term.high;
    else
      sum.add(term.high);
    sum.low = sum.low + (term.low + a[i] * area.low);
  }
  return normalised(sum.high, sum.low);
}

/// Plain sums over at most `mesh_block` triangles a lane, to be added to compensated ones.
struct MeshBlock {
  CompensatedSum<Lanes> volume{};
  Lanes sizes{};
  Lanes first[3]{};
  Lanes second[6]{};
  Lanes size[3]{};
  LaneMask flat{};  // minus their number

  RIGOR_INLINE void add(const MeshCorners& corners) {
    const DoubleDouble<Lanes> six = six_volumes(corners);
    volume.add(six);
    const Lanes d = six.high;
    sizes += absolute(d);
    flat += absolute(d) <= mesh_flat;
    const Lanes* const a = corners.at[0];
    const Lanes* const b = corners.at[1];
    const Lanes* const c = corners.at[2];
    Lanes s[3];
    int ij = 0;
    for (int i = 0; i < 3; ++i) {
      s[i] = a[i] + b[i] + c[i];
      first[i] += d * s[i];
      for (int j = 0; j <= i; ++j) {
        const Lanes q = (a[i] * a[j] + b[i] * b[j]) + (c[i] * c[j] + s[i] * s[j]);
        second[ij++] += d * q;
        if (i == j) size[i] += absolute(d) * q;
      }
    }
  }
};

/// Sums in double-double in every lane.
struct MeshLanes {
  DoubleDouble<Lanes> volume{};
  Lanes sizes{};
  DoubleDouble<Lanes> first[3]{};
  DoubleDouble<Lanes> second[6]{};
  DoubleDouble<Lanes> size[3]{};
  LaneMask flat{};

  RIGOR_INLINE void add(const MeshBlock& block) {
    volume = volume + block.volume.value();
    sizes += block.sizes;
    for (int i = 0; i < 3; ++i) first[i] = first[i] + block.first[i];
    for (int ij = 0; ij < 6; ++ij) second[ij] = second[ij] + block.second[ij];
    for (int i = 0; i < 3; ++i) size[i] = size[i] + block.size[i];
    flat += block.flat;
  }

  /// One triangle a lane with every operation in double-double. About 600 operations.
  RIGOR_INLINE void add(const MeshCorners& corners) {
    const DoubleDouble<Lanes> d = six_volumes(corners);
    volume = volume + d;
    sizes += absolute(d.high);
    flat += absolute(d.high) <= mesh_flat;
    const Lanes* const a = corners.at[0];
    const Lanes* const b = corners.at[1];
    const Lanes* const c = corners.at[2];
    DoubleDouble<Lanes> s[3];
    int ij = 0;
    for (int i = 0; i < 3; ++i) {
      s[i] = exact_sum(a[i], b[i]) + c[i];
      first[i] = first[i] + d * s[i];
      for (int j = 0; j <= i; ++j, ++ij) {
        CompensatedSum<Lanes> q;
        q.add_product(a[i], a[j]);
        q.add_product(b[i], b[j]);
        q.add_product(c[i], c[j]);
        q.add_product(s[i], s[j]);
        second[ij] = second[ij] + d * q.value();
      }
    }
  }
};

/// Adds the lanes from left to right. `total` is high, low.
RIGOR_INLINE void add_lanes(double (&total)[2], const DoubleDouble<Lanes>& sums) {
  DoubleDouble<double> sum{total[0], total[1]};
  for (int lane = 0; lane < lanes; ++lane) sum = sum + DoubleDouble<double>{sums.high[lane], sums.low[lane]};
  total[0] = sum.high;
  total[1] = sum.low;
}

inline constexpr std::size_t mesh_block = 16;  // triangles a lane

/// Σ over the lanes from `lane` on. The last triangles are made up to eight by ones without an extent.
template <bool sharp>
RIGOR_INLINE void add_share(const double* packed, const std::uint32_t* corners, std::size_t triangles,
                            std::size_t lane, MeshTotals& totals) {
  MeshLanes sums;
  const std::size_t groups = triangles / mesh_lanes;
  std::uint32_t rest[3 * mesh_lanes] = {};
  for (std::size_t n = 3 * mesh_lanes * groups; n < 3 * triangles; ++n)
    rest[n - 3 * mesh_lanes * groups] = corners[n];
  MeshBlock block;
  for (std::size_t group = 0; group <= groups; ++group) {
    const std::uint32_t* const from = group < groups ? corners + 3 * mesh_lanes * group : rest;
    const MeshCorners at = load_corners(packed, from + 3 * lane);
    if constexpr (sharp) {
      sums.add(at);
    } else {
      block.add(at);
      if (group % mesh_block == mesh_block - 1 || group == groups) {
        sums.add(block);
        block = {};
      }
    }
  }
  add_lanes(totals.volume, sums.volume);
  int ij = 0;
  for (int i = 0; i < 3; ++i) {
    add_lanes(totals.first[i], sums.first[i]);
    for (int j = 0; j <= i; ++j) add_lanes(totals.second[i][j], sums.second[ij++]);
    double size[2] = {totals.size[i], 0};
    add_lanes(size, sums.size[i]);
    totals.size[i] = size[0];
  }
  for (int n = 0; n < lanes; ++n) {
    totals.sizes += sums.sizes[n];
    totals.flat -= static_cast<std::size_t>(sums.flat[n]);
  }
}

/// Vertices as x, y, z, each at most 1 in size, and a fourth number that is not read; at least one of them.
/// `sharp`: everything in double-double. Else D and its sum only, 3 times faster.
static void mesh_sums(const double* packed, const std::uint32_t* corners, std::size_t triangles, bool sharp,
                      MeshTotals& totals) {
  totals = MeshTotals{};
  for (std::size_t lane = 0; lane < mesh_lanes; lane += lanes) {
    if (sharp)
      add_share<true>(packed, corners, triangles, lane, totals);
    else
      add_share<false>(packed, corners, triangles, lane, totals);
  }
  totals.flat -= mesh_lanes - triangles % mesh_lanes;
}

inline constexpr MeshKernels mesh_kernels = {
    .corners = mesh_corners, .box = mesh_box, .pack = mesh_pack, .sums = mesh_sums};

}  // namespace rigor::RIGOR_INSTRUCTION_SET
