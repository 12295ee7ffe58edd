// SPDX-License-Identifier: GPL-3.0-or-later
// Closed triangle meshes and the homogeneous bodies that they enclose.
#pragma once

#include <memory>
#include <string>

#include "numeric/body/body.h"
#include "numeric/kernels/mesh_sums.h"
#include "numeric/kernels/triangles.h"

namespace rigor {

struct ExactSolid;

/// Vertices at the same place become one (−0 is 0), in the order in which they come first. Triangles with two
/// corners that coincide are left out, and so are vertices that are then no corner. Cost: O(N), 6 ns a
/// triangle. Fails where a corner is no vertex or a coordinate is not finite, and says which.
[[nodiscard]] Result<Mesh> welded(const Mesh& mesh);

/// Is the surface of a welded mesh closed and its triangles oriented alike? Each edge must belong to two
/// triangles, which pass it in opposite directions. The reason names the ends of the first edge that does
/// not, in the order of their coordinates. Two bodies that touch along an edge are refused. Cost: O(N), 23 ns
/// a triangle; O(N log N) to find that edge or where edges without number meet in one vertex.
/// Fails, too, where a corner is no vertex.
[[nodiscard]] Result<void> check_closed(const Mesh& mesh);

/// What a surface encloses, with a density of 1.
struct MeshMass {
  double volume = 0;               // m³, positive
  Position centre{};               // m
  InertiaTensor second_moments{};  // ∫x_i x_j dV / V about the centre, m²: not an inertia tensor yet
  bool turned = false;             // the triangles were clockwise, all of them
  std::size_t degenerate = 0;      // triangles without an area, which do no harm
  bool is_sharp = false;           // everything was summed in double-double: what follows is known
  InertiaTensor low{};             // to be added to the second moments
  double volume_error = 0;         // bounds of errors: relative to the volume,
  double error = 0;                // of any second moment, m²
  /// In integers, where the above leaves open whether two of its moments differ.
  std::shared_ptr<const ExactSolid> exact = {};
};

/// In a unit of length that is `unit` of the mesh's. Fails where something overflows.
[[nodiscard]] Result<MeshMass> in_unit(MeshMass enclosed, double unit);

/// Welds, checks and sums up (`kernels/mesh_sums.h`: formula, source and error; where that loses digits,
/// `mesh_parts.h`, and where that loses more, integers, of bodies that fill 2^-42 of their box). Where the
/// volume is negative, all triangles are turned. Fails where a corner is no vertex, a coordinate is not
/// finite, the surface is open, the volume cannot be told from 0, or something overflows. Cost: 37 ns a
/// triangle up to 3e4 triangles (the sums take 5.5 of them); 43 ns at 1e5 and 100 ns from 5e5 on, where its
/// tables leave the caches.
[[nodiscard]] Result<MeshMass> mesh_mass(const Mesh& mesh,
                                         MeshSharpness sharpness = MeshSharpness::if_needed);

/// The homogeneous body of that mass, or of that density, as six particles (`equimomental_body`), along the
/// axes of the mesh.
[[nodiscard]] Result<Body> mesh_body(std::string name, const MeshMass& enclosed, double mass);
[[nodiscard]] Result<Body> mesh_body_of_density(std::string name, const MeshMass& enclosed, double density);

}  // namespace rigor
