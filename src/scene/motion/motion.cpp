// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/motion/motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/numeric/odeint/algebra/range_algebra.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <string_view>

#include "numeric/kernels/position.h"

namespace rigor {
namespace {

namespace odeint = boost::numeric::odeint;

/// The spin over `scale`, then the orientation. Zero at first, since odeint copies its states before their
/// use.
struct State : std::array<double, 7> {
  State() : std::array<double, 7>{} {}
};
using Algebra = odeint::range_algebra;
using Operations = odeint::default_operations;
using Stepper = odeint::controlled_runge_kutta<
    odeint::runge_kutta_fehlberg78<State, double, State, double, Algebra, Operations>>;

double size_of(const Vector3& vector) { return std::hypot(vector[0], vector[1], vector[2]); }

std::string fault_of(const MotionRequest& request) {
  if (!std::isfinite(size_of(request.spin))) return "the spin is not finite";
  if (!std::isfinite(request.duration)) return "the duration is not finite";
  if (request.rows == 0) return "no row was asked for";
  if (!(request.tolerance >= 1e-15 && request.tolerance <= 1e-2)) {
    return fmt::format("the tolerance {:g} is not between 1e-15 and 0.01", request.tolerance);
  }
  return {};
}

/// One integration: rows are added until the end, or until it stops.
class Integration {
 public:
  Integration(const SpinRates& rates, const MotionRequest& request)
      : rates_(rates), request_(request), scale_(scale_of(request)) {
    for (std::size_t i = 0; i < 3; ++i) state_[i] = request.spin[i] / scale_;
    if (request.orientation) std::copy_n(request.orientation->begin(), 4, state_.begin() + 3);
  }

  Motion run() {
    const double end = request_.duration * scale_;
    const auto last = static_cast<double>(std::max<std::size_t>(request_.rows, 2) - 1);
    step_ = end == 0 ? 0 : std::copysign(std::min(std::abs(end) / last, 0.1), end);
    add_row(0);
    for (std::size_t row = 1; row < request_.rows && motion_.stopped.empty(); ++row) {
      const double portion = static_cast<double>(row) / last;
      if (advance(end * portion, end)) add_row(request_.duration * portion);
    }
    return std::move(motion_);
  }

 private:
  /// Time runs in units of 1/scale: of the first spin, or of the duration where there is none.
  static double scale_of(const MotionRequest& request) {
    const double spin = size_of(request.spin);
    if (spin > 0) return spin;
    return request.duration != 0 ? 1 / std::abs(request.duration) : 1;
  }

  void add_row(double time) {
    motion_.times.push_back(time);
    motion_.spins.push_back({state_[0] * scale_, state_[1] * scale_, state_[2] * scale_});
    if (request_.orientation) motion_.orientations.push_back({state_[3], state_[4], state_[5], state_[6]});
  }

  /// d/dθ of the scaled state, θ = scale · t. The orientation obeys q' = q ω / 2.
  void derivative(const State& state, State& change) {
    ++motion_.evaluations;
    const Vector3 rates = rates_({state[0] * scale_, state[1] * scale_, state[2] * scale_});
    for (std::size_t i = 0; i < 3; ++i) change[i] = rates[i] / scale_ / scale_;
    std::fill(change.begin() + 3, change.end(), 0.0);
    if (!request_.orientation) return;
    const auto& [x, y, z, qw, qx, qy, qz] = static_cast<const std::array<double, 7>&>(state);
    change[3] = -(qx * x + qy * y + qz * z) / 2;
    change[4] = (qw * x + qy * z - qz * y) / 2;
    change[5] = (qw * y + qz * x - qx * z) / 2;
    change[6] = (qw * z + qx * y - qy * x) / 2;
  }

  /// Steps until exactly `target`, or says why not.
  bool advance(double target, double end) {
    while (time_ != target) {
      if (motion_.evaluations >= request_.most_evaluations) {
        return stop(fmt::format("{} evaluations of the rates are not enough", request_.most_evaluations));
      }
      if (std::abs(step_) < std::abs(end) * 1e-14) return stop("the steps became too small");
      const bool cut = std::abs(step_) >= std::abs(target - time_);
      if (!one_step(cut ? target - time_ : step_, cut)) return false;
      if (reached_) time_ = target;
    }
    return true;
  }

  bool one_step(double tried, bool cut) {
    double next = tried;
    double time = time_;
    const auto system = [this](const State& state, State& change, double) { derivative(state, change); };
    const bool success = stepper_.try_step(system, state_, time, next) == odeint::success;
    reached_ = success && cut;
    // A step that was cut short at a row says nothing against the longer one before it.
    step_ = success && cut && std::abs(next) < std::abs(step_) ? step_ : next;
    if (!are_finite(state_) || !std::isfinite(next)) return stop("the spin or its rates are not finite");
    if (success) {
      ++motion_.steps;
      time_ = time;
      normalise();
    }
    return true;
  }

  void normalise() {
    if (!request_.orientation) return;
    const double length = std::hypot(std::hypot(state_[3], state_[4]), std::hypot(state_[5], state_[6]));
    for (std::size_t i = 3; i < 7; ++i) state_[i] /= length;
  }

  bool stop(std::string_view why) {
    motion_.stopped = fmt::format("{} after {:.6g} s", why, time_ / scale_);
    return false;
  }

  const SpinRates& rates_;
  const MotionRequest& request_;
  double scale_;
  State state_{};
  double time_ = 0;  // θ
  double step_ = 0;
  bool reached_ = false;
  Stepper stepper_{
      odeint::default_error_checker<double, Algebra, Operations>(request_.tolerance, request_.tolerance)};
  Motion motion_;
};

}  // namespace

Vector3 turned(const Quaternion& orientation, const Vector3& v) {
  const auto [w, x, y, z] = orientation;
  const Vector3 once{2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])};
  return {v[0] + w * once[0] + y * once[2] - z * once[1], v[1] + w * once[1] + z * once[0] - x * once[2],
          v[2] + w * once[2] + x * once[1] - y * once[0]};
}

Quaternion composed(const Quaternion& outer, const Quaternion& inner) {
  const auto [a, b, c, d] = outer;
  const auto [w, x, y, z] = inner;
  return {a * w - b * x - c * y - d * z, a * x + b * w + c * z - d * y, a * y - b * z + c * w + d * x,
          a * z + b * y - c * x + d * w};
}

/// Four times the products of the components of the quaternion are sums of the components of its matrix; the
/// row of the greatest one is divided by it.
Quaternion turn_to(const std::array<Vector3, 3>& axes) {
  const auto& [x, y, z] = axes;
  const std::array<Quaternion, 4> products{{
      {1 + x[0] + y[1] + z[2], y[2] - z[1], z[0] - x[2], x[1] - y[0]},
      {y[2] - z[1], 1 + x[0] - y[1] - z[2], x[1] + y[0], z[0] + x[2]},
      {z[0] - x[2], x[1] + y[0], 1 - x[0] + y[1] - z[2], y[2] + z[1]},
      {x[1] - y[0], z[0] + x[2], y[2] + z[1], 1 - x[0] - y[1] + z[2]},
  }};
  std::size_t best = 0;
  for (std::size_t i = 1; i < 4; ++i) best = products[i][i] > products[best][best] ? i : best;
  Quaternion turn = products[best];
  for (double& each : turn) each /= 2 * std::sqrt(products[best][best]);
  return turn;
}

Motion integrate(const SpinRates& rates, const MotionRequest& request) {
  Motion motion;
  motion.stopped = fault_of(request);
  if (!motion.stopped.empty()) return motion;
  return Integration(rates, request).run();
}

}  // namespace rigor
