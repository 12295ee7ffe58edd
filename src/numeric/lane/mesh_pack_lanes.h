// SPDX-License-Identifier: GPL-3.0-or-later
// What is done once for every vertex and corner of a mesh before sums over its triangles.
#pragma once

#include "numeric/lane/double_double.h"
#include "numeric/lane/mesh_totals.h"

namespace rigor::RIGOR_INSTRUCTION_SET {

using MeshVertex = double __attribute__((vector_size(32)));  // x, y, z and a fourth number that is not read
using MeshVertexMask = std::int64_t __attribute__((vector_size(32)));

/// Is every corner at most `last`? last < 2^31: the highest bit of corner or of last − corner says it is not.
static bool mesh_corners(const std::uint32_t* corners, std::size_t count, std::uint32_t last) {
  std::uint32_t outside = 0;
  for (std::size_t n = 0; n < count; ++n) outside |= corners[n] | (last - corners[n]);
  return outside < 0x80000000U;
}

/// The least and the most of each coordinate; of what is not a number, anything.
static void mesh_box(const double* xyz, std::size_t vertices, double* least, double* most) {
  Lanes low[3];
  Lanes high[3];
  for (int n = 0; n < 3 * lanes; ++n) low[n / lanes][n % lanes] = high[n / lanes][n % lanes] = xyz[n % 3];
  std::size_t vertex = 0;
  for (; vertex + lanes <= vertices; vertex += lanes) {
    for (int part = 0; part < 3; ++part) {  // x y z x y z …: three registers have whole vertices
      const Lanes x = load(xyz + 3 * vertex + part * lanes);
      low[part] = select(x < low[part], x, low[part]);
      high[part] = select(x > high[part], x, high[part]);
    }
  }
  for (int i = 0; i < 3; ++i) least[i] = most[i] = xyz[i];
  for (int n = 0; n < 3 * lanes; ++n) {
    least[n % 3] = select(low[n / lanes][n % lanes] < least[n % 3], low[n / lanes][n % lanes], least[n % 3]);
    most[n % 3] = greater(high[n / lanes][n % lanes], most[n % 3]);
  }
  for (; vertex < vertices; ++vertex) {
    for (int i = 0; i < 3; ++i) {
      const double x = xyz[3 * vertex + static_cast<std::size_t>(i)];
      least[i] = select(x < least[i], x, least[i]);
      most[i] = greater(x, most[i]);
    }
  }
}

/// Differences that are known to be exact are not tried.
template <bool try_exact>
RIGOR_INLINE PackedMesh pack_vertices(const double* xyz, std::size_t vertices, const double* origin,
                                      const double* scale, const double* rest, double* packed) {
  const MeshVertex o = {origin[0], origin[1], origin[2], 0};
  const MeshVertex s = {scale[0], scale[1], scale[2], 0};
  const MeshVertex r = {rest[0], rest[1], rest[2], 0};
  MeshVertexMask finite = {-1, -1, -1, -1};
  MeshVertexMask exact = {-1, -1, -1, -1};
  for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
    MeshVertex x = {};
    if (vertex + 1 < vertices)
      __builtin_memcpy(&x, xyz + 3 * vertex, 32);
    else
      __builtin_memcpy(&x, xyz + 3 * vertex, 24);
    if constexpr (try_exact) exact &= exact_difference(x, o).low == 0;
    const MeshVertex w = (x - o) * s * r;
    finite &= (w <= 1) & (w >= -1);
    __builtin_memcpy(packed + 4 * vertex, &w, 32);
  }
  return {(finite[0] & finite[1] & finite[2]) != 0, (exact[0] & exact[1] & exact[2]) != 0};
}

/// (x − origin) scale rest into four numbers a vertex, each at most 1 in size.
static PackedMesh mesh_pack(const double* xyz, std::size_t vertices, const double* origin,
                            const double* scale, const double* rest, bool try_exact, double* packed) {
  return try_exact ? pack_vertices<true>(xyz, vertices, origin, scale, rest, packed)
                   : pack_vertices<false>(xyz, vertices, origin, scale, rest, packed);
}

}  // namespace rigor::RIGOR_INSTRUCTION_SET
