// SPDX-License-Identifier: GPL-3.0-or-later
// Volume, centre and second moments of what a triangle mesh encloses, wherever the mesh is and however thin.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/result.h"
#include "numeric/kernels/high_low.h"
#include "numeric/kernels/position.h"
#include "numeric/lane/lane_kernels.h"

namespace rigor {

/// Bounds of what the sums of a mesh in double-double lack, the last rounding to high + low included.
struct MeshErrors {
  double volume = 0;                                      // of itself
  std::array<double, 3> centre{};                         // m
  std::array<std::array<double, 3>, 3> second_moments{};  // m²
  double greatest = 0;                                    // of the second moments ii, relative to themselves
};

/// With a density of 1. The low parts are right if everything was summed in double-double (`sharp`), else 0
/// but for the volume.
struct MeshMoments {
  HighLow volume;              // m³, negative if the triangles are clockwise as seen from outside
  SharpPosition centre;        // m
  SharpTensor second_moments;  // ∫x_i x_j dV / V about the centre, m²
  bool sharp = false;
  std::size_t flat = 0;  // triangles in a plane with the point that the tetrahedra share, to 2^-99
  MeshErrors errors;     // if `sharp`; else of what cancels in the determinants alone
};

/// Are the second moments ii those of a body, and known to 2^-26 of themselves?
[[nodiscard]] Result<void> check_second_moments(const std::array<double, 3>& moments,
                                                const MeshErrors& errors);

/// Is every corner a vertex, and are there between 1 and 2^31 vertices? The reason names the first triangle
/// with a corner that is not, from 1.
[[nodiscard]] Result<void> check_corners(std::size_t vertices,
                                         std::span<const std::array<std::uint32_t, 3>> triangles,
                                         const LaneKernels& kernels = lane_kernels());

/// `if_needed`: where rounded terms would cost the second moments digits, and for small meshes.
enum class MeshSharpness { if_needed, always };

/// Of a closed surface; vertices that are no corners do not count, but must be finite. Signed tetrahedra from
/// a point c from which x − c is exact: each coordinate of c is 0 or within a factor of two of all x (P. H.
/// Sterbenz, Floating-point computation, 1974), or a short number if that will do for all x. Where it does
/// not, the differences are rounded if the body fills 1/32 of its box. The axes are scaled by powers of two.
/// With D = det(a, b, c) in double-double and s = a + b + c,
///   V = Σ D/6,  f = Σ D s/(24 V),  ∫x_i x_j dV/V = Σ D (a_i a_j + b_i b_j + c_i c_j + s_i s_j)/(120 V) − f_i
///   f_j.
/// Source: F. Tonon, J. Math. Stat. 1 (2005) 8. Cost: 5.5 ns a triangle with AVX-512, where the plain sum
/// about the origin takes 6.8; 18 ns in double-double, which is done where there are few triangles or Σ |D|
/// (a_i² + …) is more than 4 times what the second moment leaves of it: for hollow and for crooked thin
/// bodies; 1 ns more where the body fills less than 1/32 of its vertices' box, to look for unused ones. Error
/// for the coordinates as they are, at distances up to 1e12 and thicknesses down to 1e-8, measured by
/// mesh_sums_test for surfaces of one part: volume 0.9 u; centre 1 u of each coordinate or of √(ii); second
/// moment ij 3 u √(ii jj): 1.2 u on most, 1.7 u on small ellipsoids of unlike axes. Sharp: `errors`, proved
/// in mesh_sums.cpp; some N 2^-99 of the volume of the mesh's box over V. Parts that are small compared with
/// the box are lost in it: `mesh_parts.h` takes each by itself. Fails where a corner is no vertex, a
/// coordinate is not finite, the volume cannot be told from 0 (below 1e-26 of the box's volume for 1e4
/// triangles), a second moment ii is known to less than 2^-26 of itself or not positive (a surface through
/// itself, or one of several inside out), or something overflows.
[[nodiscard]] Result<MeshMoments> mesh_moments(std::span<const Position> vertices,
                                               std::span<const std::array<std::uint32_t, 3>> triangles,
                                               MeshSharpness sharpness = MeshSharpness::if_needed,
                                               const LaneKernels& kernels = lane_kernels());

}  // namespace rigor
