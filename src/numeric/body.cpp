// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/body.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "base/splitmix.h"
#include "numeric/kernels/double_double.h"
#include "numeric/uniform.h"

namespace rigor {
namespace {

constexpr std::array<char, 3> axis_names{'x', 'y', 'z'};

tl::unexpected<Error> refuse(std::string reason) { return tl::unexpected(Error{std::move(reason)}); }

}  // namespace

Result<void> check_count(const Body& body) {
  if (body.masses.empty()) return refuse("the body has no particles");
  if (body.size() > most_particles)
    return refuse(fmt::format("the body has {} particles, at most {}", body.size(), most_particles));
  return {};
}

Result<void> check_body(const Body& body) {
  if (const auto checked = check_count(body); !checked) return checked;
  double total = 0;
  for (std::size_t k = 0; k < body.size(); ++k) {
    const double mass = body.masses[k];
    if (!std::isfinite(mass) || mass < 0)
      return refuse(
          fmt::format("particle {} has the mass {} kg, which must be finite and not negative", k + 1, mass));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double x = body.positions[axis][k];
      if (!std::isfinite(x))
        return refuse(
            fmt::format("particle {} has {} = {} m, which must be finite", k + 1, axis_names[axis], x));
    }
    total += mass;
  }
  if (total == 0) return refuse("the body has no mass");
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

Result<Body> centred(Body body) {
  if (const auto checked = check_body(body); !checked) return tl::unexpected(checked.error());
  const auto centre = sharp_centre_of_mass(points_of(body));
  if (!centre) return tl::unexpected(centre.error());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (double& x : body.positions[axis]) x = away_from(x, (*centre)[axis]);
  }
  if (const auto checked = check_body(body); !checked) return tl::unexpected(checked.error());
  return body;
}

Result<Body> point_masses(std::string name, const std::vector<double>& masses,
                          const std::vector<Position>& positions) {
  if (masses.size() != positions.size())
    return refuse(fmt::format("{} masses, but {} positions", masses.size(), positions.size()));
  Body body{std::move(name), masses, {}, {}};
  for (const Position& position : positions) {
    for (std::size_t axis = 0; axis < 3; ++axis) body.positions[axis].push_back(position[axis]);
  }
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
