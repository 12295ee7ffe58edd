// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/body/body.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/splitmix.h"
#include "numeric/body/known_moments.h"
#include "numeric/kernels/point_sample.h"
#include "numeric/lane/double_double.h"
#include "numeric/program/uniform.h"

namespace rigor {
namespace {

/// The error of a centre of mass from sharp sums, relative to the extent of its body.
constexpr double centre_rounding = 0x1p-90;

/// 0.1 us each, which parts of bodies take whether they need it or not.
constexpr std::size_t most_particles_in_integers = 1000;

}  // namespace

Result<void> check_count(const Body& body) {
  if (body.masses.empty()) return refuse("the body has no particles");
  if (body.size() > most_particles)
    return refuse(fmt::format("the body has {} particles, at most {}", body.size(), most_particles));
  return {};
}

Result<void> check_body(const Body& body) {
  if (const auto checked = check_count(body); !checked) return checked;
  if (const auto checked = check_points(points_of(body)); !checked) return checked;
  const double total = std::accumulate(body.masses.begin(), body.masses.end(), 0.0);
  if (!std::isfinite(total)) return refuse("the sum of the masses overflows");
  return {};
}

PointColumns points_of(const Body& body) {
  const auto& [x, y, z] = body.positions;
  return {{x.data(), y.data(), z.data()}, body.masses.data(), body.size()};
}

double away_from(double x, const HighLow& centre) {
  const auto difference = baseline::exact_difference(x, centre.high);
  return difference.high + (difference.low - centre.low);
}

MoveErrors move_coordinates(const double* coordinates, std::size_t stride, const HighLow& centre, double unit,
                            std::span<double> into) {
  MoveErrors errors{.rounded = unit != 1};
  double extent = 0;
  for (std::size_t k = 0; k < into.size(); ++k) {
    const double x = coordinates[stride * k];
    errors.rounded = errors.rounded || baseline::exact_difference(x, centre.high).low != centre.low;
    into[k] = away_from(x, centre) * unit;
    extent = std::max(extent, std::abs(into[k]));
  }
  errors.shift = centre_rounding * extent + 0x1p-103 * std::abs(centre.high * unit) + 0x1p-1073;
  return errors;
}

namespace {

/// How far the centre of mass is off by what the masses and places of the particles are off, m: the mean of
/// the errors by mass, and what masses that are off by a part of themselves weigh otherwise.
double centre_error(const Body& body, const SharpPosition& centre) {
  double greatest = 0;
  const double mass = std::accumulate(body.masses.begin(), body.masses.end(), 0.0);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::vector<double>& each = body.errors.each[axis];
    double sum = 0;
    for (std::size_t k = 0; k < body.size(); ++k) {
      const double x = body.positions[axis][k];
      const double off = body.errors.place * std::abs(x) + body.errors.shift + (each.empty() ? 0 : each[k]);
      sum += body.masses[k] * (off + 2 * body.errors.mass * std::abs(x - centre[axis].high));
    }
    greatest = std::max(greatest, sum / mass);
  }
  return greatest * (1 + 0x1p-20);
}

}  // namespace

Result<Body> centred(Body body) {
  if (const auto checked = check_body(body); !checked) return tl::unexpected(checked.error());
  const auto centre = sharp_centre_of_mass(points_of(body));
  if (!centre) return tl::unexpected(centre.error());
  bool rounded = false;
  double shift = 0;
  const double centre_off = centre_error(body, *centre);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<double>& places = body.positions[axis];
    const MoveErrors moved = move_coordinates(places.data(), 1, (*centre)[axis], 1, places);
    rounded = rounded || moved.rounded;
    shift = std::max(shift, moved.shift);
  }
  // Errors that are relative to the coordinates before are to the coordinates now and to the shift.
  const auto far = [](const HighLow& x) { return std::abs(x.high); };
  const double moved_by = std::max({far((*centre)[0]), far((*centre)[1]), far((*centre)[2])});
  body.errors.shift += shift + centre_off + body.errors.place * moved_by * (1 + 0x1p-40);
  if (rounded) body.errors.place += 0x1.01p-53;
  if (const auto checked = check_body(body); !checked) return tl::unexpected(checked.error());
  return body;
}

std::optional<KnownInertia> known_inertia(const SharpMassSums& sums, double unit) {
  KnownInertia known{.mass = sums.mass.high, .is_sharp = true, .mass_error = 0x1p-53};
  double greatest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const HighLow moment = sums.inertia[i][j] * unit * unit;
      known.inertia[i][j] = moment.high;
      known.low[i][j] = moment.low;
      greatest = std::max(greatest, std::abs(moment.high));
    }
  }
  known.error = (sums.error + 0x1p-100) * greatest;
  if (!std::isfinite(greatest) || !std::isfinite(known.error)) return std::nullopt;
  return known;
}

Result<Body> point_masses(std::string name, const std::vector<double>& masses,
                          const std::vector<Position>& positions) {
  if (masses.size() != positions.size())
    return refuse(fmt::format("{} masses, but {} positions", masses.size(), positions.size()));
  Body body{std::move(name), masses, {}, {}};
  for (const Position& position : positions) {
    for (std::size_t axis = 0; axis < 3; ++axis) body.positions[axis].push_back(position[axis]);
  }
  if (const auto sums = sharp_mass_sums(points_of(body))) body.known = known_inertia(*sums);
  if (body.known && body.size() <= most_particles_in_integers)
    tell_moments_apart(*body.known, exact_body(points_of(body)));
  else if (body.known)
    tell_moments_apart(*body.known, [&] { return exact_body(points_of(body)).inertia; });
  return centred(std::move(body));
}

Result<Body> random_cloud(std::string name, std::size_t count, std::uint64_t seed) {
  if (count == 0) return refuse("the body has no particles");
  if (count > most_particles)  // before they are in memory
    return refuse(fmt::format("the body has {} particles, at most {}", count, most_particles));
  SplitMix bits(seed);
  Body body{std::move(name), {}, {}, {}};
  for (std::size_t k = 0; k < count; ++k) {
    body.masses.push_back(1 - uniform(bits));
    for (std::vector<double>& coordinates : body.positions) coordinates.push_back(uniform_sign(bits));
  }
  return centred(std::move(body));
}

}  // namespace rigor
