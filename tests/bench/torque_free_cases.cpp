// SPDX-License-Identifier: GPL-3.0-or-later
#include "torque_free_cases.h"

#include <algorithm>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/numeric/odeint/integrate/integrate_adaptive.hpp>
#include <boost/numeric/odeint/integrate/integrate_const.hpp>
#include <boost/numeric/odeint/stepper/bulirsch_stoer.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <cmath>
#include <limits>

#include "bench_clock.h"
#include "numeric/kernels/free_motion_reference.h"
#include "numeric/kernels/torque_free.h"
#include "numeric/kernels/torque_free_attitude.h"

namespace rigor {
namespace {

namespace odeint = boost::numeric::odeint;
constexpr double infinity = std::numeric_limits<double>::infinity();

struct FreeCase {
  std::string family;
  Position moments{};  // in their order
  Position spin{};
  double time = 0;
  bool long_run = false;
};

/// On the separatrix: I₃ (I₃ − I₂) ω₃² = I₁ (I₂ − I₁) ω₁², exactly.
std::vector<FreeCase> cases() {
  std::vector<FreeCase> all{{"I = (1, 2, 2.5), t = 100", {1, 2, 2.5}, {.6, .7, .9}, 100}};
  for (const double off : {1e-4, 1e-8, 1e-12, 0.}) {
    const std::string name =
        off == 0 ? "on the separatrix" : "separatrix + 1e" + std::to_string(std::lround(std::log10(off)));
    all.push_back({name + ", t = 10", {1, 5, 9}, {3, 1, 1 + off}, 10});
  }
  FreeCase far = all[0];
  far.family = "1e6 periods";
  far.time = static_cast<double>(period_of(far.moments, far.spin)) * (1e6 + .3);
  far.long_run = true;
  all.push_back(far);
  return all;
}

ReferenceMotion reference_of(const FreeCase& body) {
  if (!body.long_run) return moved(body.moments, at_rest_of(body.spin), body.time, true);
  const Digits70 period = period_of(body.moments, body.spin);
  return moved(body.moments, at_rest_of(body.spin),
               Digits70(body.time) - period * floor(Digits70(body.time) / period));
}

double error_of(const Position& found, const ReferenceMotion& reference) {
  Digits70 square = 0;
  Digits70 size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (!std::isfinite(found[i])) return infinity;
    square += (reference.spin[i] - found[i]) * (reference.spin[i] - found[i]);
    size += reference.spin[i] * reference.spin[i];
  }
  return static_cast<double>(sqrt(square / size));
}

double error_of(const AttitudeQuaternion& found, const ReferenceMotion& reference) {
  Digits70 along = 0;
  for (const double part : found)
    if (!std::isfinite(part)) return infinity;
  for (std::size_t i = 0; i < 4; ++i) along += reference.turn[i] * found[i];
  Digits70 square = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Digits70 error =
        along < 0 ? Digits70(found[i] + reference.turn[i]) : Digits70(found[i] - reference.turn[i]);
    square += error * error;
  }
  return static_cast<double>(sqrt(square));
}

/// What a compiler may not foresee.
template <class T>
void keep(T& value) {
  asm volatile("" : "+m"(value));
}

/// The textbook's: the modulus from 1 − k'², through Boost. What does not depend on time is set up once.
struct Textbook {
  double k = 0;
  double start = 0;
  double rate = 0;
  Position size{};

  explicit Textbook(const FreeCase& body) {
    const auto& [i1, i2, i3] = body.moments;
    const auto& [w1, w2, w3] = body.spin;
    const double energy = i1 * w1 * w1 + i2 * w2 * w2 + i3 * w3 * w3;
    const double momentum = i1 * i1 * w1 * w1 + i2 * i2 * w2 * w2 + i3 * i3 * w3 * w3;
    rate = std::sqrt((i3 - i2) * (momentum - energy * i1) / (i1 * i2 * i3));
    const double square = (i2 - i1) * (energy * i3 - momentum) / ((i3 - i2) * (momentum - energy * i1));
    k = std::sqrt(std::min(square, 1.));
    size = {std::sqrt((energy * i3 - momentum) / (i1 * (i3 - i1))),
            std::sqrt((energy * i3 - momentum) / (i2 * (i3 - i2))),
            std::sqrt((momentum - energy * i1) / (i3 * (i3 - i1)))};
    start = boost::math::ellint_1(k, std::atan2(w2 / size[1], w1 / size[0]));
  }

  [[nodiscard]] Position at(double time) const {
    double cn = 0;
    double dn = 0;
    const double sn = boost::math::jacobi_elliptic(k, start + rate * time, &cn, &dn);
    return {size[0] * cn, size[1] * sn, size[2] * dn};
  }
};

struct EulerEquations {
  Position factor{};
  explicit EulerEquations(const Position& moments) {
    for (std::size_t i = 0; i < 3; ++i)
      factor[i] = (moments[(i + 1) % 3] - moments[(i + 2) % 3]) / moments[i];
  }
  void operator()(const Position& w, Position& rate, double) const {
    rate = {factor[0] * w[1] * w[2], factor[1] * w[2] * w[0], factor[2] * w[0] * w[1]};
  }
};

/// ω and the quaternion q, dq/dt = ½ q ω.
using TurningState = std::array<double, 7>;

struct TurningEquations {
  EulerEquations spin;
  void operator()(const TurningState& state, TurningState& rate, double time) const {
    const Position w{state[0], state[1], state[2]};
    Position spin_rate{};
    spin(w, spin_rate, time);
    const double* const q = state.data() + 3;
    double scalar = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      rate[i] = spin_rate[i];
      scalar -= q[1 + i] * w[i];
      rate[4 + i] = .5 * (q[0] * w[i] + q[1 + j] * w[k] - q[1 + k] * w[j]);
    }
    rate[3] = .5 * scalar;
  }
};

/// Of length 1.
AttitudeQuaternion attitude_of(const TurningState& state) {
  AttitudeQuaternion turn{};
  double square = 0;
  for (std::size_t i = 0; i < 4; ++i) square += state[3 + i] * state[3 + i];
  for (std::size_t i = 0; i < 4; ++i) turn[i] = state[3 + i] / std::sqrt(square);
  return turn;
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A failure is not a number.
Position spin_of(const Result<TorqueFree>& motion, double time) {
  return motion ? motion->spin(time) : Position{nan, nan, nan};
}

AttitudeQuaternion attitude_of(const Result<TorqueFreeAttitude>& motion, double time) {
  return motion ? motion->at(time) : AttitudeQuaternion{nan, nan, nan, nan};
}

class TorqueFreeRows {
 public:
  std::vector<KernelRow> run() {
    for (const FreeCase& body : cases()) {
      body_ = body;
      reference_ = reference_of(body);
      add_closed_form();
      add_textbook();
      if (!body.long_run) add_integrators();
      if (!body.long_run) add_attitude();
      if (!body.long_run) add_attitude_integrators();
    }
    return std::move(rows_);
  }

 private:
  void add(const std::string& table, const std::string& name, double time, double error,
           const std::string& remark = {}) {
    rows_.push_back({table, name, body_.family, time, error, remark});
  }

  /// What throws takes forever and is all wrong.
  template <class Compute>
  void add_peer(const std::string& table, const std::string& name, const Compute& compute,
                const std::string& remark = "set-up included") {
    try {
      auto found = compute();
      const double error = error_of(found, reference_);
      const double time = least_nanoseconds([&] {
        keep(body_.spin);
        found = compute();
        keep(found);
      });
      add(table, name, time, error, remark);
    } catch (const std::exception&) {
      add(table, name, infinity, infinity, "throws");
    }
  }

  /// Times of 2,048 results; the error is that of the first.
  template <class Found, class Compute>
  void add_many(const std::string& table, const Compute& compute) {
    std::vector<Found> found(many);
    const double time = least_nanoseconds([&] {
      compute(found);
      keep(found);
    });
    add(table, "closed form, 2,048 times at once", time / many, error_of(found[0], reference_),
        "set up before");
  }

  void add_closed_form() {
    add_peer(spin_, "closed form, set-up and one time",
             [&] { return spin_of(TorqueFree::make(body_.moments, body_.spin), body_.time); });
    const auto motion = TorqueFree::make(body_.moments, body_.spin);
    add_peer(
        spin_, "closed form, one time", [&] { return spin_of(motion, body_.time); }, "set up before");
    if (!motion) return add(spin_, "closed form, 2,048 times at once", infinity, infinity, "fails");
    std::vector<double> times(many);
    for (std::size_t k = 0; k < many; ++k) times[k] = body_.time * (1 - static_cast<double>(k) / many);
    add_many<Position>(spin_, [&](std::vector<Position>& found) { motion->spins(times, found); });
  }

  void add_textbook() {
    add_peer(spin_, "Boost.Math jacobi_elliptic", [&] { return Textbook(body_).at(body_.time); });
    try {
      const Textbook motion(body_);
      add_peer(
          spin_, "Boost.Math, one time", [&] { return motion.at(body_.time); }, "set up before");
    } catch (const std::exception&) {
      add(spin_, "Boost.Math, one time", infinity, infinity, "throws");
    }
  }

  /// odeint's steppers with control of the error, at tolerances of 1e-8 to 1e-14.
  template <class State, class Integrate>
  void add_controlled(const std::string& table, const Integrate& integrate) {
    for (int digits = 8; digits <= 14; ++digits) {
      const double tolerance = std::pow(10, -digits);
      const std::string suffix = " 1e-" + std::to_string(digits);
      add_peer(table, "odeint Bulirsch–Stoer" + suffix,
               [&] { return integrate(odeint::bulirsch_stoer<State>(tolerance, tolerance)); });
      add_peer(table, "odeint DOPRI5" + suffix, [&] {
        return integrate(odeint::make_controlled<odeint::runge_kutta_dopri5<State>>(tolerance, tolerance));
      });
      add_peer(table, "odeint RKF78" + suffix, [&] {
        return integrate(
            odeint::make_controlled<odeint::runge_kutta_fehlberg78<State>>(tolerance, tolerance));
      });
    }
  }

  void add_integrators() {
    const EulerEquations equations(body_.moments);
    add_controlled<Position>(spin_, [&](auto stepper) {
      Position w = body_.spin;
      odeint::integrate_adaptive(stepper, equations, w, 0., body_.time, .1);
      return w;
    });
    add_peer(spin_, "odeint RK4, h = 0.01", [&] {
      Position w = body_.spin;
      const auto steps = static_cast<std::size_t>(std::lround(body_.time / .01));
      odeint::runge_kutta4<Position> stepper;
      for (std::size_t k = 0; k < steps; ++k)
        stepper.do_step(equations, w, static_cast<double>(k) * .01, .01);
      return w;
    });
  }

  void add_attitude_integrators() {
    const TurningEquations equations{EulerEquations(body_.moments)};
    add_controlled<TurningState>(attitude_, [&](auto stepper) {
      TurningState state{body_.spin[0], body_.spin[1], body_.spin[2], 1, 0, 0, 0};
      odeint::integrate_adaptive(stepper, equations, state, 0., body_.time, .1);
      return attitude_of(state);
    });
  }

  void add_attitude() {
    add_peer(attitude_, "closed form, set-up and one time",
             [&] { return attitude_of(TorqueFreeAttitude::make(body_.moments, body_.spin), body_.time); });
    const auto motion = TorqueFreeAttitude::make(body_.moments, body_.spin);
    add_peer(
        attitude_, "closed form, one time", [&] { return attitude_of(motion, body_.time); }, "set up before");
    if (!motion) return add(attitude_, "closed form, 2,048 times at once", infinity, infinity, "fails");
    const std::vector<double> times(many, body_.time);
    add_many<AttitudeQuaternion>(attitude_,
                                 [&](std::vector<AttitudeQuaternion>& found) { motion->at(times, found); });
  }

  static constexpr std::size_t many = 2048;
  const std::string spin_ = "torque-free spin";
  const std::string attitude_ = "torque-free attitude";
  FreeCase body_;
  ReferenceMotion reference_;
  std::vector<KernelRow> rows_;
};

}  // namespace

std::vector<KernelRow> torque_free_rows() { return TorqueFreeRows().run(); }

}  // namespace rigor
