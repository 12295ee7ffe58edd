// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/free_motion.h"

#include <algorithm>
#include <cmath>

#include "base/splitmix.h"
#include "numeric/kernels/torque_free.h"
#include "numeric/kernels/torque_free_attitude.h"

namespace rigor {
namespace {

constexpr std::size_t trials = 32;
constexpr double most_difference = 512 * 0x1p-53;

/// Does the law say at `spin` what Euler's equations say of a free body?
bool agrees(const SpinRates& rates, const Position& moments, const Vector3& spin) {
  const Vector3 found = rates(spin);
  const double square = spin[0] * spin[0] + spin[1] * spin[1] + spin[2] * spin[2];
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const double free = (moments[j] - moments[k]) / moments[i] * spin[j] * spin[k];
    const double scale = (moments[j] + moments[k]) / moments[i] * square;
    if (!(std::abs(found[i] - free) <= most_difference * scale)) return false;
  }
  return true;
}

bool is_free(const SpinRates& rates, const Position& moments, const Vector3& first) {
  const double size = std::hypot(first[0], first[1], first[2]);
  SplitMix random(trials);
  const auto component = [&] {
    return size * (std::ldexp(static_cast<double>(random.next() >> 11), -52) - 1);
  };
  if (!agrees(rates, moments, first)) return false;
  for (std::size_t trial = 1; trial < trials; ++trial) {
    Vector3 spin{};
    for (double& each : spin) each = component();
    if (!agrees(rates, moments, spin)) return false;
  }
  return true;
}

}  // namespace

std::optional<Motion> free_motion(const SpinRates& rates, const Position& moments,
                                  const MotionRequest& request) {
  const auto spin = TorqueFree::make(moments, request.spin);
  const auto attitude = TorqueFreeAttitude::make(moments, request.spin);
  if (!spin || !attitude || request.spin == Vector3{}) return std::nullopt;
  if (!std::isfinite(request.duration) || request.rows == 0) return std::nullopt;
  if (!is_free(rates, moments, request.spin)) return std::nullopt;
  Motion motion;
  motion.closed_form = true;
  motion.evaluations = trials;
  const auto last = static_cast<double>(std::max<std::size_t>(request.rows, 2) - 1);
  for (std::size_t row = 0; row < request.rows; ++row) {
    const double time = request.duration * (static_cast<double>(row) / last);
    motion.times.push_back(time);
    motion.spins.push_back(row == 0 ? request.spin : spin->spin(time));
    if (request.orientation)
      motion.orientations.push_back(composed(*request.orientation, attitude->at(time)));
  }
  return motion;
}

}  // namespace rigor
