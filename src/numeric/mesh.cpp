// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/mesh.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "numeric/bodies.h"

namespace rigor {
namespace {

constexpr double u = 0x1p-53;

tl::unexpected<Error> refuse(std::string reason) { return tl::unexpected(Error{std::move(reason)}); }

/// Sums over tetrahedra from a point.
struct Sums {
  double six_volumes = 0;  // Σ det
  double magnitude = 0;    // Σ of the sizes of the terms of det: the rounding of six_volumes is 4u of it
  Position first{};        // Σ det s
  InertiaTensor second{};  // Σ det (a a + b b + c c + s s)
  std::size_t degenerate = 0;
};

/// Of the triangles' corners, each as often as it is one: a vertex that no triangle has may be anywhere.
Position mean_corner(const Mesh& mesh) {
  const double count = 3 * static_cast<double>(mesh.triangles.size());
  Position mean{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double origin = mesh.vertices[mesh.triangles.front()[0]][k];
    for (const auto& triangle : mesh.triangles) {
      for (const std::uint32_t corner : triangle) mean[k] += (mesh.vertices[corner][k] - origin) / count;
    }
    mean[k] += origin;
  }
  return mean;
}

void add_tetrahedron(Sums& sums, const Position& a, const Position& b, const Position& c) {
  double determinant = 0;
  double magnitude = 0;
  double area = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    determinant += a[i] * (b[j] * c[k] - b[k] * c[j]);
    magnitude += std::abs(a[i]) * (std::abs(b[j] * c[k]) + std::abs(b[k] * c[j]));
    area += std::abs((b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]));
  }
  sums.six_volumes += determinant;
  sums.magnitude += magnitude;
  if (area == 0) ++sums.degenerate;
  Position s{};
  for (std::size_t i = 0; i < 3; ++i) {
    s[i] = a[i] + b[i] + c[i];
    sums.first[i] += determinant * s[i];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j <= i; ++j)
      sums.second[i][j] += determinant * (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + s[i] * s[j]);
  }
}

Sums sums_about(const Mesh& mesh, const Position& centre) {
  Sums sums;
  for (const auto& triangle : mesh.triangles) {
    std::array<Position, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 3; ++i) corners[k][i] = mesh.vertices[triangle[k]][i] - centre[i];
    }
    add_tetrahedron(sums, corners[0], corners[1], corners[2]);
  }
  return sums;
}

}  // namespace

Result<MeshMass> mesh_mass(const Mesh& mesh) {
  const Mesh surface = welded(mesh);
  if (surface.triangles.empty()) return refuse("the mesh has no triangles");
  if (const auto closed = check_closed(surface); !closed) return tl::unexpected(closed.error());
  const Position mean = mean_corner(surface);
  const Sums sums = sums_about(surface, mean);
  if (!std::isfinite(sums.magnitude)) return refuse("the volume overflows");
  const double rounding = 4 * u * static_cast<double>(surface.triangles.size()) * sums.magnitude;
  if (std::abs(sums.six_volumes) <= rounding) return refuse("the mesh encloses no volume");

  MeshMass mass;
  mass.turned = sums.six_volumes < 0;
  mass.volume = std::abs(sums.six_volumes) / 6;
  mass.degenerate = mesh.triangles.size() - surface.triangles.size() + sums.degenerate;
  Position from_mean{};
  for (std::size_t i = 0; i < 3; ++i) {
    from_mean[i] = sums.first[i] / (4 * sums.six_volumes);
    mass.centre[i] = mean[i] + from_mean[i];
  }
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      const double moment = sums.second[i][j] / (20 * sums.six_volumes) - from_mean[i] * from_mean[j];
      if (!std::isfinite(moment)) return refuse("the second moments overflow");
      mass.second_moments[i][j] = mass.second_moments[j][i] = moment;
    }
  }
  return mass;
}

Result<Body> mesh_body(std::string name, const MeshMass& enclosed, double mass) {
  if (!std::isfinite(mass) || mass <= 0)
    return refuse(fmt::format("the mesh has the mass {} kg, which must be finite and positive", mass));
  return equimomental_body(std::move(name), mass, enclosed.second_moments);
}

}  // namespace rigor
