// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/motion/split_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/check.h"
#include "numeric/kernels/torque_free.h"
#include "numeric/kernels/torque_free_step.h"

namespace rigor {
namespace {

/// Of the greatest spin: above what roundings and kicks leave, but for phases that turn on for a long time.
constexpr double least_change = 1e-10;
/// Of rates, relative to the terms of a free body's: what rounding alone makes of them.
constexpr double rate_rounding = 16 * 0x1p-53;

/// What the law has beyond a free body's, 0 where that is no more than rounding.
Vector3 beyond_free(const Vector3& all, const Position& moments, const Vector3& spin) {
  const Position free = free_spin_rates(moments, spin);
  Vector3 beyond{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const double terms = (moments[j] + moments[k]) / moments[i] * std::abs(spin[j] * spin[k]);
    const double difference = all[i] - free[i];
    if (!(std::abs(difference) <= rate_rounding * terms)) beyond[i] = difference;
  }
  return beyond;
}

double greatest_spin(const Motion& motion) {
  double greatest = 0;
  for (const Vector3& spin : motion.spins)
    greatest = std::max(greatest, std::hypot(spin[0], spin[1], spin[2]));
  return greatest;
}

class Splitting {
 public:
  Splitting(const SpinRates& rates, const Position& moments, const MotionRequest& request)
      : moments_(moments), request_(request), spin_(request.spin) {
    beyond_free_ = [&rates, moments](const Vector3& spin) { return beyond_free(rates(spin), moments, spin); };
    if (request.orientation) attitude_ = *request.orientation;
  }

  Motion run(std::size_t split) {
    const auto last = static_cast<double>(std::max<std::size_t>(request_.rows, 2) - 1);
    const double step = request_.duration / last / static_cast<double>(split);
    add_row(0);
    for (std::size_t row = 1; row < request_.rows && motion_.stopped.empty(); ++row) {
      kick(step / 2);
      for (std::size_t k = 1; k <= split && why_.empty(); ++k) {
        turn(step);
        kick(k == split ? step / 2 : step);
      }
      motion_.steps += split;
      if (!why_.empty())
        stop(why_);
      else if (!are_finite(spin_))
        stop("the spin or its rates are not finite");
      else
        add_row(request_.duration * (static_cast<double>(row) / last));
    }
    return std::move(motion_);
  }

 private:
  std::string too_much_work() const {
    return fmt::format("{} evaluations of the rates are not enough", request_.most_evaluations);
  }

  void add_row(double time) {
    motion_.times.push_back(time);
    motion_.spins.push_back(spin_);
    if (request_.orientation) motion_.orientations.push_back(attitude_);
  }

  void stop(const std::string& why) {
    motion_.stopped = fmt::format("{} after {:.6g} s", why, motion_.times.back());
  }

  void kick(double time) {
    if (!why_.empty() || !are_finite(spin_)) return;
    if (motion_.evaluations >= request_.most_evaluations) {
      why_ = too_much_work();
      return;
    }
    const Motion kicked =
        integrate(beyond_free_, {.spin = spin_,
                                 .duration = time,
                                 .rows = 2,
                                 .tolerance = 1e-13,
                                 .most_evaluations = request_.most_evaluations - motion_.evaluations});
    motion_.evaluations += kicked.evaluations;
    if (kicked.stopped.empty())
      spin_ = kicked.spins.back();
    else
      why_ = motion_.evaluations >= request_.most_evaluations
                 ? too_much_work()
                 : kicked.stopped.substr(0, kicked.stopped.rfind(" after "));
  }

  void turn(double time) {
    if (!why_.empty()) return;
    FreeBodies body{.count = 1, .time = time};
    for (std::size_t i = 0; i < 3; ++i) body.moments[i] = &moments_[i];
    for (std::size_t i = 0; i < 3; ++i) body.spin[i] = &spin_[i];
    for (std::size_t i = 0; i < 4; ++i) body.attitude[i] = &attitude_[i];
    if (step_free_bodies(body) != 0 && why_.empty())
      why_ = "the free turn of a step is beyond the range of doubles";
  }

  Position moments_;
  const MotionRequest& request_;
  SpinRates beyond_free_;
  Vector3 spin_;
  Quaternion attitude_{1, 0, 0, 0};
  Motion motion_;
  std::string why_;  // the steps cannot go on
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
  const double spin = greatest_spin(again);
  const double least = least_change + 4 * rate_rounding * spin * std::abs(request.duration);
  if (change > 0 && next > least * spin) motion.split_order = std::log2(change / next);
  return motion;
}

}  // namespace rigor
