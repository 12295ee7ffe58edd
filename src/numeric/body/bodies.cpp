// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/body/bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "numeric/body/body_errors.h"
#include "numeric/body/inertia.h"
#include "numeric/body/known_moments.h"
#include "numeric/kernels/principal_moments.h"
#include "numeric/lane/double_double.h"

namespace rigor {
namespace {

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
  const auto sums = sharp_mass_sums(points_of(points));
  if (!sums) return tl::unexpected(sums.error());
  KnownInertia whole = known_inertia(*sums).value_or(KnownInertia{});
  if (!whole.is_sharp) return refuse("the inertia tensor overflows");
  double mass_error = 0;
  double greatest = 0;
  for (const auto& [body, offset] : parts) {
    const KnownInertia& part = *body.known;
    whole.is_sharp = whole.is_sharp && part.is_sharp;
    whole.error += part.error;
    mass_error = std::max(mass_error, part.mass_error);
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        const HighLow sum =
            HighLow{whole.inertia[i][j], whole.low[i][j]} + HighLow{part.inertia[i][j], part.low[i][j]};
        if (!std::isfinite(sum.high)) return refuse("the inertia tensor overflows");
        whole.inertia[i][j] = sum.high;
        whole.low[i][j] = sum.low;
        greatest = std::max(greatest, std::abs(sum.high));
      }
    }
  }
  whole.mass_error += mass_error;
  whole.error += (4 * mass_error + static_cast<double>(parts.size()) * 0x1p-103) * greatest;
  return whole;
}

/// M (tr(S) 1 − S).
KnownInertia inertia_of(const SecondMoments& second, double mass, double mass_error) {
  const SharpTensor& s = second.moments;
  KnownInertia known{.mass = mass, .is_sharp = true, .mass_error = mass_error};
  double greatest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const HighLow sum = i == j ? s[(i + 1) % 3][(i + 1) % 3] + s[(i + 2) % 3][(i + 2) % 3] : -s[i][j];
      const HighLow moment = sum * mass;
      known.inertia[i][j] = moment.high;
      known.low[i][j] = moment.low;
      greatest = std::max(greatest, std::abs(moment.high));
    }
  }
  known.error = 2 * mass * second.error + (0x1p-102 + mass_error) * greatest + 0x1p-1072;
  return known;
}

std::shared_ptr<const ExactMoments> along_axis(ExactMoments moments, std::size_t step) {
  for (Position& axis : moments.axes)
    std::ranges::rotate(axis, axis.end() - static_cast<std::ptrdiff_t>(step));
  return std::make_shared<const ExactMoments>(std::move(moments));
}

/// Of a whole, from the integers of all its parts.
void tell_moments_apart(KnownInertia& known, const std::vector<PlacedBody>& parts) {
  constexpr std::size_t most_parts = 64;
  if (parts.size() > most_parts) return;
  std::vector<PlacedExactBody> exact;
  for (const auto& [body, offset] : parts) {
    if (body.known->integers == nullptr) return;
    exact.push_back({body.known->integers.get(), offset});
  }
  tell_moments_apart(known, exact_joined(exact));
}

std::size_t size_of(const std::vector<PlacedBody>& parts) {
  std::size_t size = 0;
  for (const PlacedBody& part : parts) size += part.body.size();
  return size;
}

/// The masses of all parts, which lose theirs one after the other: most of them are never held twice.
void take_masses(Body& whole, std::vector<PlacedBody>& parts) {
  whole.masses.reserve(size_of(parts));
  for (PlacedBody& part : parts) {
    const std::vector<double> masses = std::exchange(part.body.masses, {});
    whole.masses.insert(whole.masses.end(), masses.begin(), masses.end());
  }
}

/// The same with the places along an axis, to which a part adds its own.
void take_places(Body& whole, std::vector<PlacedBody>& parts, std::size_t axis, const HighLow& centre) {
  whole.positions[axis].reserve(whole.size());
  whole.errors.each[axis].reserve(whole.size());
  for (auto& [part, offset] : parts) {
    const double place = away_from(offset[axis], centre);  // not at `offset`: that may be far
    const ErrorBounds errors = place_errors(part, axis);
    part.errors.each[axis] = {};
    const std::vector<double> places = std::exchange(part.positions[axis], {});
    for (std::size_t k = 0; k < places.size(); ++k) {
      const double x = places[k];
      whole.positions[axis].push_back(x + place);
      whole.errors.each[axis].push_back(errors.of(k, x) + 2 * 0x1p-53 * (std::abs(x) + std::abs(place)));
    }
  }
}

}  // namespace

/// Second moments of flat bodies come out negative by rounding, in units of the greatest one.
constexpr double negative_rounding = 1e-12;

Body along_axis(Body body, std::size_t axis) {
  RIGOR_CHECK(axis < 3, axis);
  const std::size_t step = (axis + 1) % 3;  // z, the axis 2, goes to (2 + step) mod 3
  auto positions = std::exchange(body.positions, {});
  auto errors = std::exchange(body.errors.each, {});
  for (std::size_t i = 0; i < 3; ++i) {
    body.positions[(i + step) % 3] = std::move(positions[i]);
    body.errors.each[(i + step) % 3] = std::move(errors[i]);
  }
  if (body.known) {
    const InertiaTensor inertia = body.known->inertia;
    const InertiaTensor low = body.known->low;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        body.known->inertia[(i + step) % 3][(j + step) % 3] = inertia[i][j];
        body.known->low[(i + step) % 3][(j + step) % 3] = low[i][j];
      }
    }
    KnownInertia& known = *body.known;
    if (known.exact != nullptr) known.exact = along_axis(*known.exact, step);
    if (known.integers != nullptr)
      known.integers = std::make_shared<const ExactBody>(along_axis(*known.integers, step));
  }
  return body;
}

Result<Body> joined(std::string name, std::vector<PlacedBody> parts) {
  if (parts.empty()) return refuse("the body has no parts");
  const Body points = points_of_parts(parts);
  const auto centre = sharp_centre_of_mass(points_of(points));
  if (!centre) return tl::unexpected(centre.error());
  Body whole{std::move(name), {}, {}, {}};
  if (std::ranges::all_of(parts, [](const PlacedBody& part) { return part.body.known.has_value(); })) {
    const auto known = joined_inertia(parts, points);
    if (!known) return tl::unexpected(known.error());
    whole.known = *known;
    tell_moments_apart(*whole.known, parts);
  }
  for (const auto& part : parts) whole.errors.mass = std::max(whole.errors.mass, part.body.errors.mass);
  take_masses(whole, parts);
  for (std::size_t axis = 0; axis < 3; ++axis) take_places(whole, parts, axis, (*centre)[axis]);
  return centred(std::move(whole));
}

Result<Body> equimomental_body(std::string name, double mass, const SecondMoments& second,
                               double mass_error) {
  if (const auto checked = check_mass(mass); !checked) return tl::unexpected(checked.error());
  const auto principal = principal_axes(second.moments);
  if (!principal) return tl::unexpected(principal.error());
  const Position moments = principal->principal.rounded().moments;
  const double least = std::ranges::min(moments);
  const double most = std::ranges::max(moments);
  if (least < -negative_rounding * most)
    return refuse(
        fmt::format("its mean square extent along an axis is {:g} m^2, which cannot be negative", least));
  Body body{std::move(name), std::vector<double>(6, mass / 6), {}, inertia_of(second, mass, mass_error)};
  for (std::size_t k = 0; k < 3; ++k) {
    const double distance = std::sqrt(3 * std::max(0.0, moments[k]));
    for (const double sign : {1.0, -1.0}) {
      for (std::size_t i = 0; i < 3; ++i)
        body.positions[i].push_back(sign * distance * principal->axes[k][i]);
    }
  }
  body.errors.mass = 0x1.01p-53 + mass_error;
  body.errors.each = equimomental_errors(body, principal->axes, second);
  if (const auto checked = check_body(body); !checked) return tl::unexpected(checked.error());
  return body;
}

Result<Body> equimomental_body(std::string name, double mass, const InertiaTensor& second_moments) {
  SecondMoments second;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) second.moments[i][j].high = second_moments[i][j];
  }
  return equimomental_body(std::move(name), mass, second);
}

Result<Body> body_with_inertia(std::string name, double mass, const InertiaTensor& inertia) {
  if (const auto checked = check_mass(mass); !checked) return tl::unexpected(checked.error());
  if (const auto checked = check_inertia(inertia); !checked) return tl::unexpected(checked.error());
  SecondMoments second;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const HighLow twice = baseline::exact_difference(inertia[j][j], inertia[i][i]) + inertia[k][k];
    second.moments[i][i] = twice / HighLow{2 * mass, 0};
    second.error = std::max(second.error, 0x1p-101 * std::abs(second.moments[i][i].high));
    for (const std::size_t l : {j, k}) {
      second.moments[i][l] = HighLow{-inertia[i][l], 0} / HighLow{mass, 0};
      second.error = std::max(second.error, 0x1p-101 * std::abs(second.moments[i][l].high));
    }
  }
  Result<Body> body = equimomental_body(std::move(name), mass, second);
  if (!body) return body;
  body->known = KnownInertia{.mass = mass, .inertia = inertia, .is_sharp = true};
  tell_moments_apart(*body->known, exact_body(exact_tensor(inertia), mass));
  return body;
}

}  // namespace rigor
