// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/stability.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace rigor {
namespace {

constexpr double tolerance = 1e-14;
constexpr double negligible_growth = 1e-9;  // Ω² over ω²: this is 0 but for rounding
constexpr double smallest_error = 1e-10;    // errors beneath are those of the integration
constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// When `component` reaches `level` on the way, after `from`; found between rows, then by Newton's method,
/// whose steps integrate from the row before. Nothing: not within `until`.
std::optional<double> time_of(const SpinRates& rates, const Vector3& start, std::size_t component,
                              double level, double until) {
  const MotionRequest request{.spin = start, .duration = until, .rows = 401, .tolerance = tolerance};
  const Motion motion = integrate(rates, request);
  if (!motion.stopped.empty()) return std::nullopt;
  for (std::size_t row = 1; row + 1 < motion.spins.size(); ++row) {
    const double before = motion.spins[row][component] - level;
    const double after = motion.spins[row + 1][component] - level;
    if (before == 0 ? after == 0 : (before < 0) == (after < 0)) continue;
    double at = (motion.times[row + 1] - motion.times[row]) * before / (before - after);
    for (int iteration = 0; iteration < 8; ++iteration) {
      const Motion there =
          integrate(rates, {.spin = motion.spins[row], .duration = at, .rows = 2, .tolerance = tolerance});
      if (!there.stopped.empty()) return std::nullopt;
      const double step = (there.spins.back()[component] - level) / rates(there.spins.back())[component];
      if (!std::isfinite(step)) return std::nullopt;
      at -= step;
      if (std::abs(step) <= 1e-15 * (motion.times[row] + at)) break;
    }
    return motion.times[row] + at;
  }
  return std::nullopt;
}

Vector3 pushed(std::size_t axis, double spin, double push) {
  Vector3 start{};
  start[axis] = spin;
  start[(axis + 1) % 3] = push * spin;
  return start;
}

double oscillation(const SpinRates& rates, std::size_t axis, const Vector3& start, double predicted) {
  const double half_turn = std::numbers::pi / std::sqrt(predicted);
  const auto time = time_of(rates, start, (axis + 2) % 3, 0, 3 * half_turn);
  return time ? std::pow(std::numbers::pi / *time, 2) : none;
}

double growth(const SpinRates& rates, std::size_t axis, const Vector3& start, double predicted) {
  const std::size_t across = (axis + 1) % 3;
  const double doubling = std::acosh(2.0) / std::sqrt(-predicted);
  const auto time = time_of(rates, start, across, 2 * start[across], 3 * doubling);
  return time ? -std::pow(std::acosh(2.0) / *time, 2) : none;
}

/// f(2τ) − 2 f(τ) + f(0) = −Ω² τ² f(τ), with τ = 1/ω; of the push along both axes across.
double drift(const SpinRates& rates, std::size_t axis, Vector3 start) {
  start[(axis + 2) % 3] = start[(axis + 1) % 3];
  const double spin = std::abs(start[axis]);
  const Motion motion =
      integrate(rates, {.spin = start, .duration = 2 / spin, .rows = 3, .tolerance = tolerance});
  if (!motion.stopped.empty()) return none;
  double worst = 0;
  for (const std::size_t across : {(axis + 1) % 3, (axis + 2) % 3}) {
    const double second = motion.spins[2][across] - 2 * motion.spins[1][across] + motion.spins[0][across];
    const double squared = -second / start[across] * spin * spin;
    if (!(std::abs(squared) <= std::abs(worst))) worst = squared;
  }
  return worst;
}

/// d log(error) / d log(push), between the ends of what is not rounding.
double order_of(const std::vector<StabilityPoint>& points) {
  const StabilityPoint* first = nullptr;
  const StabilityPoint* last = nullptr;
  for (const StabilityPoint& point : points) {
    if (!(point.error > smallest_error)) continue;
    if (first == nullptr) first = &point;
    last = &point;
  }
  if (first == last || first->push == last->push) return none;
  return std::log(first->error / last->error) / std::log(first->push / last->push);
}

}  // namespace

std::string_view name_of(SpinFate fate) {
  if (fate == SpinFate::neither) return "neither";
  return fate == SpinFate::grows ? "grows" : "oscillates";
}

StabilityMeasurement measure_stability(const SpinRates& rates, const SpinFunction& squared, std::size_t axis,
                                       double spin, std::span<const double> pushes) {
  StabilityMeasurement result{
      .axis = axis, .predicted = squared(pushed(axis, spin, 0)), .points = {}, .problem = {}};
  if (!std::isfinite(result.predicted)) {
    result.problem = "the formula is not finite for this body";
    return result;
  }
  if (!std::isfinite(rates(pushed(axis, spin, 0.1))[axis])) {
    result.problem = "the equations do not determine the rates of the spin for this body";
    return result;
  }
  const bool degenerate = std::abs(result.predicted) <= negligible_growth * spin * spin;
  result.fate = degenerate             ? SpinFate::neither
                : result.predicted > 0 ? SpinFate::oscillates
                                       : SpinFate::grows;
  const double scale = degenerate ? spin * spin : std::abs(result.predicted);
  for (const double push : pushes) {
    const Vector3 start = pushed(axis, spin, push);
    const double measured = degenerate             ? drift(rates, axis, start)
                            : result.predicted > 0 ? oscillation(rates, axis, start, result.predicted)
                                                   : growth(rates, axis, start, result.predicted);
    if (std::isnan(measured)) result.problem = "not every push gave what the formula says";
    result.points.push_back(
        {push, measured, std::abs(measured - (degenerate ? 0 : result.predicted)) / scale});
  }
  result.order = order_of(result.points);
  return result;
}

}  // namespace rigor
