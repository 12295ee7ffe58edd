// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/motion/free_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/splitmix.h"
#include "numeric/kernels/torque_free.h"
#include "numeric/kernels/torque_free_attitude.h"

namespace rigor {
namespace {

constexpr std::size_t trials = 32;
constexpr std::size_t along_path = 1024;
constexpr double most_difference = 16 * 0x1p-53;
constexpr double slowest = 1e-140;  // so that squares of the spin keep all their digits
constexpr double fastest = 1e100;   // a needle's may be 2^100 times as large

/// Of the law with that of a free body with the moments.
class Comparison {
 public:
  Comparison(const SpinRates& rates, const Position& moments, const MotionRequest& request)
      : rates_(rates),
        moments_(moments),
        size_(std::hypot(request.spin[0], request.spin[1], request.spin[2])),
        most_over_time_(request.tolerance * size_ / std::abs(request.duration)) {}

  [[nodiscard]] bool agrees_anywhere() const {
    SplitMix random(trials);
    for (std::size_t trial = 0; trial < trials; ++trial) {
      Vector3 spin{};
      for (double& each : spin)
        each = size_ * (std::ldexp(static_cast<double>(random.next() >> 11), -52) - 1);
      if (!agrees(spin)) return false;
    }
    return true;
  }

  [[nodiscard]] bool agrees(const Vector3& spin) const {
    const Vector3 found = rates_(spin);
    const Position free = free_spin_rates(moments_, spin);
    const double square = spin[0] * spin[0] + spin[1] * spin[1] + spin[2] * spin[2];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      const double scale = (moments_[j] + moments_[k]) / moments_[i] * square;
      const double most = std::min(most_difference * scale, most_over_time_);
      if (!std::isfinite(scale) || !(std::abs(found[i] - free[i]) <= most)) return false;
    }
    return true;
  }

 private:
  const SpinRates& rates_;
  const Position& moments_;
  double size_;
  double most_over_time_;
};

/// In s; infinite for a steady spin and on the separatrix.
double period_of(const FreeSpin& spin) {
  const bool hyperbolic = spin.kind == FreeSpinKind::hyperbolic;
  if (spin.kind == FreeSpinKind::steady || (hyperbolic && spin.half_period[0] == 0))
    return std::numeric_limits<double>::infinity();
  return 2 * (hyperbolic ? spin.half_period[0] : 1) / (std::abs(spin.rate[0]) * spin.scale);
}

bool agrees_on_path(const Comparison& comparison, const TorqueFree& motion, double duration) {
  const double span = std::copysign(std::min(std::abs(duration), period_of(motion.constants())), duration);
  for (std::size_t at = 0; at < along_path; ++at) {
    const double portion = static_cast<double>(at) / static_cast<double>(along_path);
    if (!comparison.agrees(motion.spin(span * portion))) return false;
  }
  return true;
}

/// Along the axis of the middle moment, and along it alone: what pushes it aside, however little, grows.
bool is_about_middle_axis(const Position& moments, const Vector3& spin) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    if (spin[j] == 0 && spin[k] == 0) return (moments[i] > moments[j]) != (moments[i] > moments[k]);
  }
  return false;
}

bool is_served(const MotionRequest& request) {
  const double size = std::hypot(request.spin[0], request.spin[1], request.spin[2]);
  return size >= slowest && size <= fastest && std::isfinite(request.duration) && request.rows != 0 &&
         request.tolerance >= 1e-15 && request.tolerance <= 1e-2;
}

/// Adds the attitudes to the rows. False: one of them is not finite.
bool add_orientations(Motion& motion, const Position& moments, const MotionRequest& request) {
  const auto attitude = TorqueFreeAttitude::make(moments, request.spin);
  if (!attitude) return false;
  for (const double time : motion.times) {
    motion.orientations.push_back(composed(*request.orientation, attitude->at(time)));
    if (!are_finite(motion.orientations.back())) return false;
  }
  return true;
}

}  // namespace

std::optional<Motion> free_motion(const SpinRates& rates, const Position& moments,
                                  const MotionRequest& request) {
  if (!is_served(request)) return std::nullopt;
  const auto spin = TorqueFree::make(moments, request.spin);
  if (!spin) return std::nullopt;
  if (is_about_middle_axis(moments, request.spin)) {
    const Vector3 push = rates(request.spin);
    if (push != Vector3{}) return std::nullopt;
  }
  const Comparison comparison(rates, moments, request);
  if (!comparison.agrees(request.spin) || !comparison.agrees_anywhere()) return std::nullopt;
  if (!agrees_on_path(comparison, *spin, request.duration)) return std::nullopt;
  Motion motion;
  motion.closed_form = true;
  motion.evaluations = 1 + trials + along_path + request.rows;
  const auto last = static_cast<double>(std::max<std::size_t>(request.rows, 2) - 1);
  for (std::size_t row = 0; row < request.rows; ++row) {
    const double time = request.duration * (static_cast<double>(row) / last);
    motion.times.push_back(time);
    motion.spins.push_back(row == 0 ? request.spin : spin->spin(time));
    if (!are_finite(motion.spins.back()) || !comparison.agrees(motion.spins.back())) return std::nullopt;
  }
  if (request.orientation && !add_orientations(motion, moments, request)) return std::nullopt;
  return motion;
}

bool high_parts_suffice(const SharpPosition& moments, const MotionRequest& request) {
  const double turn = std::hypot(request.spin[0], request.spin[1], request.spin[2]) * request.duration;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& one = moments[(i + 1) % 3];
    const auto& other = moments[(i + 2) % 3];
    const double left_out = std::abs(one.low - other.low);
    const bool is_small = left_out <= 1e-12 * std::abs(one.high - other.high);
    if (!is_small && !(left_out / moments[i].high * std::abs(turn) <= request.tolerance)) return false;
  }
  return true;
}

}  // namespace rigor
