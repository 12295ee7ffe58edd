// SPDX-License-Identifier: GPL-3.0-or-later
// Closed meshes whose sums lose digits, by families, with references for the exact doubles: for tests and
// benchmarks. The same on every machine.
#pragma once

#include <string>
#include <vector>

#include "numeric/mesh/mesh.h"
#include "numeric/run/run_decimal.h"

namespace rigor {

struct MeshFamily {
  std::string name;
  std::vector<Mesh> meshes;
};

/// Spheres and tori at distances from 0 to 1e12; boxes and random tetrahedra; plates, rods and hollow spheres
/// of thickness 1e-2 to 1e-8, turned, at distances of up to 1e8; coordinates of 32 bits; scales of 1e±100.
/// The curved ones have about `triangles` triangles.
[[nodiscard]] std::vector<MeshFamily> mesh_families(std::size_t triangles);

/// `sphere_mesh` of at least so many.
[[nodiscard]] Mesh fine_sphere(std::size_t triangles);

using Digits100 = Decimal<100>;

struct MeshReference {
  Digits100 volume;
  std::array<Digits100, 3> centre;
  std::array<std::array<Digits100, 3>, 3> second;  // ∫x_i x_j dV / V about the centre
};

/// Over the faces by Gauss's theorem, not over tetrahedra: ∫x_i² dV = ⅓ ∮ x_i³ n_i dA, ∫x_i x_j dV = ½ ∮ x_i²
/// x_j n_i dA, … in integers of any length.
[[nodiscard]] MeshReference mesh_reference(const Mesh& mesh);

/// Of what was computed, in units of 2^-53.
struct MeshError {
  double volume = 0;  // relative
  double centre = 0;  // of each coordinate, relative to it or to √(ii), whichever is greater
  double entry = 0;   // of second moment ij, relative to √(ii jj)
  double tensor = 0;  // relative to the Frobenius norm

  void widen(const MeshError& other);
};

[[nodiscard]] MeshError mesh_error(const MeshReference& exact, const Digits100& volume,
                                   const std::array<Digits100, 3>& centre,
                                   const std::array<std::array<Digits100, 3>, 3>& second);

/// The textbook: ∫x_i x_j dV = Σ det(a, b, c)/120 (a_i a_j + b_i b_j + c_i c_j + s_i s_j) about the origin,
/// or about the mean of the vertices, then the parallel-axis theorem.
struct PlainMeshSums {
  double volume = 0;
  Position centre{};
  InertiaTensor second{};
};
[[nodiscard]] PlainMeshSums plain_mesh_sums(const Mesh& mesh, const Position& about = {});
[[nodiscard]] Position vertex_mean(const Mesh& mesh);
[[nodiscard]] MeshError plain_error(const MeshReference& exact, const PlainMeshSums& sums);

}  // namespace rigor
