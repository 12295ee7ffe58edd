// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/motion/split_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"
#include "numeric/kernels/torque_free.h"
#include "numeric/kernels/torque_free_step.h"

namespace rigor {
namespace {

/// Of the first spin: above what roundings and kicks leave.
constexpr double least_change = 1e-10;

class Splitting {
 public:
  Splitting(const SpinRates& rates, const Position& moments, const MotionRequest& request)
      : moments_(moments), request_(request), spin_(request.spin) {
    beyond_free_ = [&rates, moments](const Vector3& spin) {
      const Vector3 all = rates(spin);
      const Position free = free_spin_rates(moments, spin);
      return Vector3{all[0] - free[0], all[1] - free[1], all[2] - free[2]};
    };
    if (request.orientation) attitude_ = *request.orientation;
  }

  Motion run(std::size_t split) {
    const auto last = static_cast<double>(std::max<std::size_t>(request_.rows, 2) - 1);
    const double step = request_.duration / last / static_cast<double>(split);
    add_row(0);
    for (std::size_t row = 1; row < request_.rows && motion_.stopped.empty(); ++row) {
      kick(step / 2);
      for (std::size_t k = 1; k <= split; ++k) {
        turn(step);
        kick(k == split ? step / 2 : step);
      }
      motion_.steps += split;
      if (motion_.evaluations > request_.most_evaluations)
        stop(fmt::format("{} evaluations of the rates are not enough", request_.most_evaluations));
      else if (!are_finite(spin_))
        stop("the spin or its rates are not finite");
      else
        add_row(request_.duration * (static_cast<double>(row) / last));
    }
    return std::move(motion_);
  }

 private:
  void add_row(double time) {
    motion_.times.push_back(time);
    motion_.spins.push_back(spin_);
    if (request_.orientation) motion_.orientations.push_back(attitude_);
  }

  void stop(const std::string& why) {
    motion_.stopped = fmt::format("{} after {:.6g} s", why, motion_.times.back());
  }

  void kick(double time) {
    if (!are_finite(spin_)) return;
    const Motion kicked =
        integrate(beyond_free_, {.spin = spin_, .duration = time, .rows = 2, .tolerance = 1e-13});
    motion_.evaluations += kicked.evaluations;
    if (kicked.stopped.empty())
      spin_ = kicked.spins.back();
    else
      spin_.fill(std::numeric_limits<double>::quiet_NaN());
  }

  void turn(double time) {
    FreeBodies body{.count = 1, .time = time};
    for (std::size_t i = 0; i < 3; ++i) body.moments[i] = &moments_[i];
    for (std::size_t i = 0; i < 3; ++i) body.spin[i] = &spin_[i];
    for (std::size_t i = 0; i < 4; ++i) body.attitude[i] = &attitude_[i];
    step_free_bodies(body);
  }

  Position moments_;
  const MotionRequest& request_;
  SpinRates beyond_free_;
  Vector3 spin_;
  Quaternion attitude_{1, 0, 0, 0};
  Motion motion_;
};

double greatest_change(const Motion& one, const Motion& other) {
  double greatest = 0;
  for (std::size_t row = 0; row < one.spins.size(); ++row)
    for (std::size_t i = 0; i < 3; ++i)
      greatest = std::max(greatest, std::abs(one.spins[row][i] - other.spins[row][i]));
  return greatest;
}

}  // namespace

Motion split_motion(const SpinRates& rates, const Position& moments, const MotionRequest& request,
                    std::size_t split) {
  RIGOR_CHECK(split > 0);
  Motion motion = Splitting(rates, moments, request).run(split);
  if (!motion.stopped.empty()) return motion;
  const Motion twice = Splitting(rates, moments, request).run(2 * split);
  const Motion again = Splitting(rates, moments, request).run(4 * split);
  if (!twice.stopped.empty() || !again.stopped.empty()) return motion;
  const double change = greatest_change(motion, twice);
  const double next = greatest_change(twice, again);
  const double size = std::hypot(request.spin[0], request.spin[1], request.spin[2]);
  if (next > least_change * size) motion.split_order = std::log2(change / next);
  return motion;
}

}  // namespace rigor
