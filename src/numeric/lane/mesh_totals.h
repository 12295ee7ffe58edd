// SPDX-License-Identifier: GPL-3.0-or-later
// What is summed over the tetrahedra that a point makes with the triangles of a mesh, as high + low. Six
// volumes D = det(a, b, c) of each, a, b, c its corners from the point; s = a + b + c.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rigor {

struct MeshTotals {
  double volume[2] = {};        // Σ D
  double first[3][2] = {};      // Σ D s_i
  double second[3][3][2] = {};  // Σ D (a_i a_j + b_i b_j + c_i c_j + s_i s_j) for j ≤ i
  double sizes = 0;             // Σ |D|, rounded
  double size[3] = {};          // Σ |D| (a_i² + b_i² + c_i² + s_i²), rounded; fast sums only
  std::size_t flat = 0;         // |D| ≤ `mesh_flat`
};

/// The rounding of a D is below this, if all coordinates are at most 1 in size.
inline constexpr double mesh_flat = 0x1p-99;

/// Of all coordinates of a mesh.
struct PackedMesh {
  bool finite = false;
  bool exact = false;  // x − origin was not rounded
};

/// `mesh_pack_lanes.h`, `mesh_sums_lanes.h`.
struct MeshKernels {
  bool (*corners)(const std::uint32_t* corners, std::size_t count, std::uint32_t last) = nullptr;
  void (*box)(const double* xyz, std::size_t vertices, double* least, double* most) = nullptr;
  PackedMesh (*pack)(const double* xyz, std::size_t vertices, const double* origin, const double* scale,
                     const double* rest, bool try_exact, double* packed) = nullptr;
  void (*sums)(const double* packed, const std::uint32_t* corners, std::size_t triangles, bool sharp,
               MeshTotals& totals) = nullptr;
};

}  // namespace rigor
