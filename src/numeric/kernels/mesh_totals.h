// SPDX-License-Identifier: GPL-3.0-or-later
// What is summed over the tetrahedra that a point makes with the triangles of a mesh, as high + low. Six
// volumes D = det(a, b, c) of each, a, b, c its corners from the point; s = a + b + c.
#pragma once

#include <cstddef>

namespace rigor {

struct MeshTotals {
  double volume[2] = {};        // Σ D
  double first[3][2] = {};      // Σ D s_i
  double second[3][3][2] = {};  // Σ D (a_i a_j + b_i b_j + c_i c_j + s_i s_j) for j ≤ i
  double size[3] = {};          // Σ |D| (a_i² + b_i² + c_i² + s_i²), rounded; fast sums only
  std::size_t flat = 0;         // |D| ≤ `mesh_flat`
};

/// The rounding of a D is below this, if all coordinates are at most 1 in size.
inline constexpr double mesh_flat = 0x1p-99;

}  // namespace rigor
