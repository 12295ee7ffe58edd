// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/kernels/point_sample.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rigor {
namespace {

constexpr std::size_t group_points = 8;

/// Groups of 8 points, `step` points apart; all points where they are fewer.
struct PointGroups {
  std::size_t groups = 0;
  std::size_t step = 0;

  explicit PointGroups(std::size_t count) {
    // For n points with like masses, ε of mass_sums.h is about 1/n; up to 0.07 meets the bound in the first
    // pass.
    constexpr std::size_t least_groups = 8;
    constexpr std::size_t most_groups = 16;
    constexpr std::size_t points_a_group = 32;
    const std::size_t all_groups = count / group_points;
    if (all_groups == 0) return;
    groups = std::clamp(count / points_a_group, std::min(least_groups, all_groups), most_groups);
    step = all_groups / groups * group_points;
  }
};

std::size_t first_with_mass(const PointColumns& points) {
  for (std::size_t k = 0; k < points.count; ++k)
    if (points.mass[points.stride * k] > 0) return k;
  return 0;
}

/// What the lane kernel gives, in the same order, of scaled points.
void sample_scaled(const PointColumns& points, const PointGroups& sample, const PointScale& scale,
                   const double (&origin)[3], double (&sums)[4][group_points]) {
  const double length = std::ldexp(1.0, scale.length);
  const std::size_t sampled = sample.groups == 0 ? points.count : sample.groups * group_points;
  for (std::size_t n = 0; n < sampled; ++n) {
    const std::size_t place = n % group_points;
    const std::size_t k = points.stride * (n / group_points * sample.step + place);
    if (points.mass[k] == 0) continue;
    const double mass = points.mass[k] * std::ldexp(1.0, scale.mass);
    for (std::size_t i = 0; i < 3; ++i) sums[i][place] += mass * (points.position[i][k] * length - origin[i]);
    sums[3][place] += mass;
  }
}

/// The exponent that takes a number to 2^target, as far as its power of two is a normal number.
int exponent_to(double number, int target) {
  return number == 0 ? 0 : std::clamp(target - std::ilogb(number), -1022, 1022);
}

}  // namespace

Result<void> check_points(const PointColumns& points) {
  constexpr std::array<char, 3> axis_names{'x', 'y', 'z'};
  double heaviest = 0;
  for (std::size_t k = 0; k < points.count; ++k) {
    const double mass = points.mass[points.stride * k];
    if (!std::isfinite(mass) || mass < 0)
      return refuse(
          fmt::format("particle {} has the mass {} kg, which must be finite and not negative", k + 1, mass));
    for (std::size_t i = 0; i < 3; ++i) {
      const double x = points.position[i][points.stride * k];
      if (!std::isfinite(x))
        return refuse(
            fmt::format("particle {} has {} = {} m, which must be finite", k + 1, axis_names[i], x));
    }
    heaviest = std::max(heaviest, mass);
  }
  if (heaviest == 0) return refuse("the body has no mass");
  return {};
}

PointReach reach_of(const PointColumns& points) {
  double greatest = 0;
  double half_spread = 0;  // the whole may overflow
  double heaviest = 0;
  bool coincident = true;
  const std::size_t first = points.stride * first_with_mass(points);
  for (std::size_t k = first; k < points.stride * points.count; k += points.stride) {
    if (points.mass[k] == 0) continue;
    heaviest = std::max(heaviest, points.mass[k]);
    for (const double* const x : points.position) {
      greatest = std::max(greatest, std::abs(x[k]));
      half_spread = std::max(half_spread, std::abs(x[k] / 2 - x[first] / 2));
      coincident = coincident && x[k] == x[first];
    }
  }
  if (!coincident) half_spread = std::max(half_spread, 0x1p-1074);
  return {{std::min(exponent_to(half_spread, -1), exponent_to(greatest, 900)), exponent_to(heaviest, 960)},
          coincident};
}

SharpPosition sampled_centre(const PointColumns& points, const PointScale& scale) {
  double origin[3];
  const std::size_t first = points.stride * first_with_mass(points);
  for (std::size_t i = 0; i < 3; ++i) origin[i] = points.position[i][first] * std::ldexp(1.0, scale.length);
  const PointGroups sample(points.count);
  double sums[4][group_points] = {};
  if (sample.groups == 0 || !scale.is_one())
    sample_scaled(points, sample, scale, origin, sums);
  else
    lane_kernels().sample_points(places_of(points), sample.groups, sample.step, origin, sums);
  std::array<double, 4> total{};
  for (std::size_t i = 0; i < 4; ++i)
    for (const double sum : sums[i]) total[i] += sum;
  SharpPosition centre;
  for (std::size_t i = 0; i < 3; ++i) {
    const double shifted = origin[i] + total[i] / total[3];
    centre[i].high = total[3] > 0 && std::isfinite(shifted) ? shifted : origin[i];
  }
  return centre;
}

}  // namespace rigor
