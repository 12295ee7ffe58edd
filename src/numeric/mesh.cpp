// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "numeric/bodies.h"
#include "numeric/kernels/mesh_sums.h"

namespace rigor {
namespace {

tl::unexpected<Error> refuse(std::string reason) { return tl::unexpected(Error{std::move(reason)}); }

/// Without an area: two edges from one corner are parallel, to rounding. Edges are scaled by a power of two.
bool is_degenerate(const Position& a, const Position& b, const Position& c) {
  double longest = 0;
  for (std::size_t i = 0; i < 3; ++i)
    longest = std::max({longest, std::abs(b[i] / 2 - a[i] / 2), std::abs(c[i] / 2 - a[i] / 2)});
  if (longest == 0) return true;
  const int exponent = std::ilogb(longest);
  Position ab{};
  Position ac{};
  for (std::size_t i = 0; i < 3; ++i) {
    ab[i] = std::scalbn(b[i] / 2 - a[i] / 2, -exponent);
    ac[i] = std::scalbn(c[i] / 2 - a[i] / 2, -exponent);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    if (ab[j] * ac[k] != ab[k] * ac[j]) return false;
  }
  return true;
}

std::size_t count_degenerate(const Mesh& mesh) {
  const auto is_flat = [&](const std::array<std::uint32_t, 3>& t) {
    return is_degenerate(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
  };
  return static_cast<std::size_t>(std::count_if(mesh.triangles.begin(), mesh.triangles.end(), is_flat));
}

}  // namespace

Result<MeshMass> mesh_mass(const Mesh& mesh) {
  if (mesh.triangles.empty()) return refuse("the mesh has no triangles");
  const Result<Mesh> surface = welded(mesh);
  if (!surface) return tl::unexpected(surface.error());
  if (surface->triangles.empty()) return refuse("the mesh has no triangles");
  if (const auto closed = check_closed(*surface); !closed) return tl::unexpected(closed.error());
  const auto moments = mesh_moments(surface->vertices, surface->triangles);
  if (!moments) return tl::unexpected(moments.error());

  MeshMass mass;
  mass.turned = moments->volume.high < 0;
  mass.volume = std::abs(moments->volume.high);
  mass.degenerate = mesh.triangles.size() - surface->triangles.size();
  if (moments->flat > 0) mass.degenerate += count_degenerate(*surface);
  for (std::size_t i = 0; i < 3; ++i) {
    mass.centre[i] = moments->centre[i].high;
    for (std::size_t j = 0; j < 3; ++j) mass.second_moments[i][j] = moments->second_moments[i][j].high;
  }
  return mass;
}

Result<Body> mesh_body(std::string name, const MeshMass& enclosed, double mass) {
  if (!std::isfinite(mass) || mass <= 0)
    return refuse(fmt::format("the mesh has the mass {} kg, which must be finite and positive", mass));
  return equimomental_body(std::move(name), mass, enclosed.second_moments);
}

}  // namespace rigor
