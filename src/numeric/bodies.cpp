// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "numeric/inertia.h"
#include "numeric/kernels/principal_moments.h"

namespace rigor {
namespace {

tl::unexpected<Error> refuse(std::string reason) { return tl::unexpected(Error{std::move(reason)}); }

Result<void> check_mass(double mass) {
  if (!std::isfinite(mass) || mass <= 0)
    return refuse(fmt::format("the body has the mass {} kg, which must be finite and positive", mass));
  return {};
}

/// The parts as points: the mass of each at its offset.
Body points_of_parts(const std::vector<PlacedBody>& parts) {
  Body points;
  for (const auto& [body, offset] : parts) {
    points.masses.push_back(body.known ? body.known->mass : total_mass(body));
    for (std::size_t axis = 0; axis < 3; ++axis) points.positions[axis].push_back(offset[axis]);
  }
  return points;
}

/// `points`: of all parts, whose inertia is known.
Result<KnownInertia> joined_inertia(const std::vector<PlacedBody>& parts, const Body& points) {
  const auto sums = mass_sums(points_of(points));
  if (!sums) return tl::unexpected(sums.error());
  KnownInertia whole{sums->mass, sums->inertia};
  for (const PlacedBody& part : parts) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        whole.inertia[i][j] += part.body.known->inertia[i][j];
        if (!std::isfinite(whole.inertia[i][j])) return refuse("the inertia tensor overflows");
      }
    }
  }
  return whole;
}

}  // namespace

/// Second moments of flat bodies come out negative by rounding, in units of the greatest one.
constexpr double negative_rounding = 1e-12;

Body along_axis(Body body, std::size_t axis) {
  RIGOR_CHECK(axis < 3, axis);
  const std::size_t step = (axis + 1) % 3;  // z, the axis 2, goes to (2 + step) mod 3
  auto positions = std::exchange(body.positions, {});
  for (std::size_t i = 0; i < 3; ++i) body.positions[(i + step) % 3] = std::move(positions[i]);
  if (body.known) {
    const InertiaTensor inertia = body.known->inertia;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) body.known->inertia[(i + step) % 3][(j + step) % 3] = inertia[i][j];
    }
  }
  return body;
}

Result<Body> joined(std::string name, const std::vector<PlacedBody>& parts) {
  if (parts.empty()) return refuse("the body has no parts");
  const Body points = points_of_parts(parts);
  const auto centre = sharp_centre_of_mass(points_of(points));
  if (!centre) return tl::unexpected(centre.error());
  Body whole{std::move(name), {}, {}, {}};
  if (std::all_of(parts.begin(), parts.end(), [](const PlacedBody& part) { return part.body.known; })) {
    const auto known = joined_inertia(parts, points);
    if (!known) return tl::unexpected(known.error());
    whole.known = *known;
  }
  for (const auto& [body, offset] : parts) {
    whole.masses.insert(whole.masses.end(), body.masses.begin(), body.masses.end());
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double place = away_from(offset[axis], (*centre)[axis]);  // not `offset`: that may be far
      for (const double x : body.positions[axis]) whole.positions[axis].push_back(x + place);
    }
  }
  return centred(std::move(whole));
}

Result<Body> equimomental_body(std::string name, double mass, const InertiaTensor& second_moments) {
  if (const auto checked = check_mass(mass); !checked) return tl::unexpected(checked.error());
  const auto principal = principal_axes(second_moments);
  if (!principal) return tl::unexpected(principal.error());
  const Position moments = principal->principal.values();
  const double least = *std::min_element(moments.begin(), moments.end());
  const double most = *std::max_element(moments.begin(), moments.end());
  if (least < -negative_rounding * most)
    return refuse(
        fmt::format("its mean square extent along an axis is {:g} m^2, which cannot be negative", least));
  Body body{std::move(name), std::vector<double>(6, mass / 6), {}, KnownInertia{mass, {}}};
  for (std::size_t k = 0; k < 3; ++k) {
    const double distance = std::sqrt(3 * std::max(0.0, moments[k]));
    for (const double sign : {1.0, -1.0}) {
      for (std::size_t i = 0; i < 3; ++i)
        body.positions[i].push_back(sign * distance * principal->axes[k][i]);
    }
  }
  const double trace = second_moments[0][0] + second_moments[1][1] + second_moments[2][2];
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      body.known->inertia[i][j] = mass * ((i == j ? trace : 0) - second_moments[i][j]);
  }
  if (const auto checked = check_body(body); !checked) return tl::unexpected(checked.error());
  return body;
}

Result<Body> body_with_inertia(std::string name, double mass, const InertiaTensor& inertia) {
  if (const auto checked = check_mass(mass); !checked) return tl::unexpected(checked.error());
  if (const auto checked = check_inertia(inertia); !checked) return tl::unexpected(checked.error());
  InertiaTensor second_moments{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) second_moments[i][j] = -inertia[i][j] / mass;
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    second_moments[i][i] = (inertia[j][j] - inertia[i][i] + inertia[k][k]) / 2 / mass;
  }
  Result<Body> body = equimomental_body(std::move(name), mass, second_moments);
  if (body) body->known = KnownInertia{.mass = mass, .inertia = inertia, .low = {}, .is_sharp = true};
  return body;
}

}  // namespace rigor
