// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/mesh/mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "numeric/body/bodies.h"
#include "numeric/body/known_moments.h"
#include "numeric/kernels/mesh_sums.h"
#include "numeric/mesh/mesh_parts.h"

namespace rigor {
namespace {

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
  return static_cast<std::size_t>(std::ranges::count_if(mesh.triangles, is_flat));
}

/// More than that lost to the determinants, and parts are taken one by one.
constexpr double much_lost = 0x1p-60;
/// And more than that, the whole in integers.
constexpr double too_much_lost = 0x1p-30;

/// Does a volume fill 2^-42 of the box of the vertices? A sheet that is flat but for rounding does not.
bool fills_some_of_box(double volume, const Mesh& surface) {
  constexpr int least = -42;
  int bits = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto [low, high] =
        std::ranges::minmax(surface.vertices, {}, [i](const Position& vertex) { return vertex[i]; });
    const double half = high[i] / 2 - low[i] / 2;
    if (half == 0) return false;
    bits += std::ilogb(half) + 1;
  }
  return std::ilogb(volume) >= bits + least;
}

/// Nothing where integers would take too long, and where what is enclosed is no body.
std::optional<MeshMoments> moments_in_integers(const Mesh& surface) {
  constexpr double rounding = 0x1p-103;
  constexpr double last_place = 0x1p-1073;  // of two parts
  const auto solid = exact_solid(surface);
  if (!solid) return std::nullopt;
  MeshMoments moments;
  moments.sharp = true;
  moments.flat = 1;  // not counted
  moments.volume =
      rounded_quotient(solid->is_turned ? Integer(-solid->volume) : solid->volume, 6, solid->exponent);
  moments.errors.volume = moments.errors.greatest = rounding;
  if (!(std::abs(moments.volume.high) >= std::numeric_limits<double>::min())) return std::nullopt;
  if (!fills_some_of_box(moments.volume.high, surface)) return std::nullopt;
  const ExactTensor& second = solid->second_moments;
  for (std::size_t i = 0; i < 3; ++i) {
    if (second.entries[i][i] <= 0) return std::nullopt;
    moments.centre[i] = rounded_quotient(solid->centre[i], solid->volume, solid->centre_exponent);
    moments.errors.centre[i] = rounding * std::abs(moments.centre[i].high) + last_place;
    for (std::size_t j = 0; j < 3; ++j) {
      moments.second_moments[i][j] = rounded_quotient(second.entries[i][j], second.divisor, second.exponent);
      const double size = std::abs(moments.second_moments[i][j].high);
      if (!std::isfinite(size)) return std::nullopt;
      moments.errors.second_moments[i][j] = rounding * size + last_place;
    }
  }
  return moments;
}

SecondMoments second_moments_of(const MeshMass& mass) {
  SecondMoments second{{}, mass.error};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) second.moments[i][j] = {mass.second_moments[i][j], mass.low[i][j]};
  return second;
}

template <class InertiaOf>
Result<Body> body_of(std::string name, const MeshMass& enclosed, double mass, double mass_error,
                     const InertiaOf& exact_inertia) {
  if (!std::isfinite(mass) || mass <= 0)
    return refuse(fmt::format("the mesh has the mass {} kg, which must be finite and positive", mass));
  auto body = equimomental_body(std::move(name), mass, second_moments_of(enclosed), mass_error);
  if (!body) return body;
  body->known->is_sharp = enclosed.is_sharp;
  if (enclosed.exact == nullptr) return body;
  if (const auto moments = exact_moments(exact_inertia(*enclosed.exact)))
    body->known->exact = std::make_shared<const ExactMoments>(*moments);
  return body;
}

/// In one, or, where that loses digits, by its parts, or, where both lose more, in integers. A part may be
/// refused that alone encloses no volume.
Result<MeshMoments> moments_of_surface(const Mesh& surface, MeshSharpness sharpness) {
  auto whole = mesh_moments(surface.vertices, surface.triangles, sharpness);
  if (whole && whole->errors.greatest <= much_lost) return whole;
  const std::vector<Mesh> parts = connected_parts(surface);
  auto best = whole;
  if (parts.size() > 1) {
    const auto joined = moments_of_parts(parts);
    if (!whole || (joined && joined->errors.greatest < whole->errors.greatest)) best = joined;
  }
  if (best && best->errors.greatest <= too_much_lost) return best;
  const auto exact = moments_in_integers(surface);
  return exact ? *exact : best;
}

}  // namespace

Result<MeshMass> in_unit(MeshMass enclosed, double unit) {
  const double square = unit * unit;
  enclosed.volume *= unit * square;
  enclosed.volume_error += 4 * 0x1p-53;
  for (std::size_t i = 0; i < 3; ++i) {
    enclosed.centre[i] *= unit;
    for (std::size_t j = 0; j < 3; ++j) {
      const auto moment = HighLow{enclosed.second_moments[i][j], enclosed.low[i][j]} * unit * unit;
      if (!std::isfinite(moment.high)) return refuse("the second moments overflow");
      enclosed.second_moments[i][j] = moment.high;
      enclosed.low[i][j] = moment.low;
      enclosed.error = std::max(enclosed.error, 0x1p-103 / square * std::abs(moment.high));
    }
  }
  enclosed.error = 2 * enclosed.error * square + 0x1p-1072;
  if (enclosed.exact != nullptr)
    enclosed.exact = std::make_shared<const ExactSolid>(times_unit(*enclosed.exact, unit));
  if (!std::isfinite(enclosed.volume)) return refuse("the volume overflows");
  if (enclosed.volume < std::numeric_limits<double>::min()) return refuse("the volume underflows");
  return enclosed;
}

Result<MeshMass> mesh_mass(const Mesh& mesh, MeshSharpness sharpness) {
  if (mesh.triangles.empty()) return refuse("the mesh has no triangles");
  const Result<Mesh> surface = welded(mesh);
  if (!surface) return tl::unexpected(surface.error());
  if (surface->triangles.empty()) return refuse("the mesh has no triangles");
  if (const auto closed = check_closed(*surface); !closed) return tl::unexpected(closed.error());
  const auto moments = moments_of_surface(*surface, sharpness);
  if (!moments) return tl::unexpected(moments.error());

  MeshMass mass;
  mass.turned = moments->volume.high < 0;
  mass.volume = std::abs(moments->volume.high);
  mass.degenerate = mesh.triangles.size() - surface->triangles.size();
  mass.is_sharp = moments->sharp;
  mass.volume_error = moments->errors.volume + 0x1p-53;
  if (moments->flat > 0) mass.degenerate += count_degenerate(*surface);
  for (std::size_t i = 0; i < 3; ++i) {
    mass.centre[i] = moments->centre[i].high;
    for (std::size_t j = 0; j < 3; ++j) {
      mass.second_moments[i][j] = moments->second_moments[i][j].high;
      mass.low[i][j] = moments->second_moments[i][j].low;
      mass.error = std::max(mass.error, moments->errors.second_moments[i][j]);
    }
  }
  if (mass.is_sharp && may_have_equal_moments(moments->second_moments, mass.error)) {
    if (const auto solid = exact_solid(*surface)) mass.exact = std::make_shared<const ExactSolid>(*solid);
  }
  return mass;
}

Result<Body> mesh_body(std::string name, const MeshMass& enclosed, double mass) {
  return body_of(std::move(name), enclosed, mass, 0,
                 [mass](const ExactSolid& solid) { return inertia_with_mass(solid, mass); });
}

Result<Body> mesh_body_of_density(std::string name, const MeshMass& enclosed, double density) {
  return body_of(std::move(name), enclosed, density * enclosed.volume, enclosed.volume_error + 0x1p-53,
                 [density](const ExactSolid& solid) { return inertia_with_density(solid, density); });
}

}  // namespace rigor
