// SPDX-License-Identifier: GPL-3.0-or-later
// Closed triangle meshes and the homogeneous bodies that they enclose.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "numeric/body.h"

namespace rigor {

/// Triangles by their corners, anticlockwise as seen from outside.
struct Mesh {
  std::vector<Position> vertices;  // m
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Vertices at the same place become one (−0 is 0). Triangles of which two corners coincide are left out.
/// Cost: O(N log N).
[[nodiscard]] Mesh welded(const Mesh& mesh);

/// Is the surface of a welded mesh closed and its triangles oriented alike? Each edge must belong to two
/// triangles, which pass it in opposite directions. The reason names the ends of an edge that does not. Two
/// bodies that touch along an edge are refused. Cost: O(N log N).
[[nodiscard]] Result<void> check_closed(const Mesh& mesh);

/// What a surface encloses, with a density of 1.
struct MeshMass {
  double volume = 0;               // m³, positive
  Position centre{};               // m
  InertiaTensor second_moments{};  // ∫x_i x_j dV / V about the centre, m²: not an inertia tensor yet
  bool turned = false;             // the triangles were clockwise, all of them
  std::size_t degenerate = 0;      // triangles without an area, which do no harm
};

/// Welds and checks, then adds up the tetrahedra from the mean of their corners, so that a distance from the
/// origin costs no more digits than the coordinates have lost. Where the volume is negative, all triangles
/// are turned. Fails where the surface is open, the volume cannot be told from 0, or something overflows.
/// Formula: ∫x_i x_j dV over (0, a, b, c) = det(a, b, c)/120 (a_i a_j + b_i b_j + c_i c_j + s_i s_j), s = a +
/// b + c. Source: F. Tonon, J. Math. Stat. 1 (2005) 8. Error, measured on 8,192 triangles: 4e-15 relative,
/// 2e-14 at a distance of 1e8 sizes, 9e-15 for a thickness of 1e-4.
[[nodiscard]] Result<MeshMass> mesh_mass(const Mesh& mesh);

/// The homogeneous body of that mass as six particles (`equimomental_body`), along the axes of the mesh.
[[nodiscard]] Result<Body> mesh_body(std::string name, const MeshMass& enclosed, double mass);

}  // namespace rigor
