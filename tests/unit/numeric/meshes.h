// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes for tests.
#pragma once

#include <cmath>
#include <map>

#include "numeric/mesh/mesh.h"

namespace rigor {

/// With sides a, b, c from a corner, as twelve triangles.
inline Mesh box_mesh(const Position& sides, const Position& corner) {
  Mesh mesh;
  for (std::uint32_t k = 0; k < 8; ++k) {
    Position vertex = corner;
    for (std::uint32_t axis = 0; axis < 3; ++axis) vertex[axis] += (k >> axis & 1) != 0 ? sides[axis] : 0;
    mesh.vertices.push_back(vertex);
  }
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    const std::uint32_t i = 1U << axis;
    const std::uint32_t j = 1U << (axis + 1) % 3;
    const std::uint32_t k = 1U << (axis + 2) % 3;
    mesh.triangles.push_back({0, k, j});
    mesh.triangles.push_back({j, k, j + k});
    mesh.triangles.push_back({i, i + j, i + k});
    mesh.triangles.push_back({i + j, i + j + k, i + k});
  }
  return mesh;
}

/// The corner tetrahedron (0, e_1, e_2, e_3).
inline Mesh tetrahedron_mesh() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}};
}

/// An octahedron of which each triangle is cut into four `times` times, with all vertices moved onto the unit
/// sphere.
inline Mesh sphere_mesh(int times) {
  Mesh mesh{{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
            {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  for (int time = 0; time < times; ++time) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [found, is_new] =
          middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.vertices.size()));
      if (is_new) {
        Position m{};
        double square = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          m[k] = mesh.vertices[a][k] + mesh.vertices[b][k];
          square += m[k] * m[k];
        }
        for (double& x : m) x /= std::sqrt(square);
        mesh.vertices.push_back(m);
      }
      return found->second;
    };
    std::vector<std::array<std::uint32_t, 3>> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::uint32_t ab = middle(a, b);
      const std::uint32_t bc = middle(b, c);
      const std::uint32_t ca = middle(c, a);
      for (const std::array<std::uint32_t, 3>& part :
           {std::array{a, ab, ca}, std::array{b, bc, ab}, std::array{c, ca, bc}, std::array{ab, bc, ca}})
        finer.push_back(part);
    }
    mesh.triangles = finer;
  }
  return mesh;
}

inline Mesh shifted(Mesh mesh, double distance) {
  for (Position& vertex : mesh.vertices)
    for (double& x : vertex) x += distance;
  return mesh;
}

}  // namespace rigor
