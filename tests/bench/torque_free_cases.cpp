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
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>

#include "numeric/kernels/free_motion_reference.h"
#include "numeric/kernels/torque_free.h"
#include "numeric/kernels/torque_free_attitude.h"

namespace rigor {
namespace {

namespace odeint = boost::numeric::odeint;
using Clock = std::chrono::steady_clock;

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
    if (!std::isfinite(found[i])) return std::numeric_limits<double>::infinity();
    square += (reference.spin[i] - found[i]) * (reference.spin[i] - found[i]);
    size += reference.spin[i] * reference.spin[i];
  }
  return static_cast<double>(sqrt(square / size));
}

double error_of(const AttitudeQuaternion& found, const ReferenceMotion& reference) {
  Digits70 along = 0;
  for (std::size_t i = 0; i < 4; ++i) along += reference.turn[i] * found[i];
  Digits70 square = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Digits70 error =
        along < 0 ? Digits70(found[i] + reference.turn[i]) : Digits70(found[i] - reference.turn[i]);
    square += error * error;
  }
  return static_cast<double>(sqrt(square));
}

/// Least time of one call over runs of `repeats`, for 50 ms.
double nanoseconds(const std::function<void()>& run, int repeats) {
  double best = std::numeric_limits<double>::infinity();
  const auto start = Clock::now();
  do {
    const auto begin = Clock::now();
    for (int k = 0; k < repeats; ++k) run();
    best = std::min(best, std::chrono::duration<double, std::nano>(Clock::now() - begin).count() / repeats);
  } while (Clock::now() - start < std::chrono::milliseconds(50));
  return best;
}

/// What a compiler may not foresee.
template <class T>
void keep(T& value) {
  asm volatile("" : "+m"(value));
}

/// The textbook's: the modulus from 1 − k'², through Boost.
Position textbook(const FreeCase& body) {
  const auto& [i1, i2, i3] = body.moments;
  const auto& [w1, w2, w3] = body.spin;
  const double energy = i1 * w1 * w1 + i2 * w2 * w2 + i3 * w3 * w3;
  const double momentum = i1 * i1 * w1 * w1 + i2 * i2 * w2 * w2 + i3 * i3 * w3 * w3;
  const double rate = std::sqrt((i3 - i2) * (momentum - energy * i1) / (i1 * i2 * i3));
  const double square = (i2 - i1) * (energy * i3 - momentum) / ((i3 - i2) * (momentum - energy * i1));
  const double k = std::sqrt(std::min(square, 1.));
  const double size1 = std::sqrt((energy * i3 - momentum) / (i1 * (i3 - i1)));
  const double size2 = std::sqrt((energy * i3 - momentum) / (i2 * (i3 - i2)));
  const double size3 = std::sqrt((momentum - energy * i1) / (i3 * (i3 - i1)));
  const double start = boost::math::ellint_1(k, std::atan2(w2 / size2, w1 / size1));
  double cn = 0;
  double dn = 0;
  const double sn = boost::math::jacobi_elliptic(k, start + rate * body.time, &cn, &dn);
  return {size1 * cn, size2 * sn, size3 * dn};
}

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

class TorqueFreeRows {
 public:
  std::vector<KernelRow> run() {
    for (const FreeCase& body : cases()) {
      body_ = body;
      reference_ = reference_of(body);
      add_closed_form();
      add_peer("Boost.Math jacobi_elliptic", 100, [&] { return textbook(body_); });
      if (!body.long_run) add_integrators();
      if (!body.long_run) add_attitude();
    }
    return std::move(rows_);
  }

 private:
  void add(const std::string& table, const std::string& name, double time, double error,
           const std::string& remark = {}) {
    rows_.push_back({table, name, body_.family, time, error, remark});
  }

  void add_peer(const std::string& name, int repeats, const std::function<Position()>& compute,
                const std::string& remark = "set-up included") {
    double error = std::numeric_limits<double>::infinity();
    Position found{};
    try {
      found = compute();
      error = error_of(found, reference_);
    } catch (const std::exception&) {
      return add(spin_, name, 0, error, "throws");
    }
    const double time = nanoseconds(
        [&] {
          keep(body_.spin);
          found = compute();
          keep(found);
        },
        repeats);
    add(spin_, name, time, error, remark);
  }

  void add_closed_form() {
    add_peer("closed form, set-up and one time", 1000,
             [&] { return TorqueFree::make(body_.moments, body_.spin)->spin(body_.time); });
    const auto motion = TorqueFree::make(body_.moments, body_.spin);
    add_peer(
        "closed form, one time", 1000, [&] { return motion->spin(body_.time); }, "set up before");
    std::vector<double> times(2048);
    for (std::size_t k = 0; k < times.size(); ++k)
      times[k] = body_.time * (1 - static_cast<double>(k) / 2048);
    std::vector<Position> spins(times.size());
    const double time = nanoseconds(
                            [&] {
                              motion->spins(times, spins);
                              keep(spins);
                            },
                            1) /
                        2048;
    add(spin_, "closed form, 2,048 times at once", time, error_of(spins[0], reference_), "set up before");
  }

  void add_integrators() {
    const EulerEquations equations(body_.moments);
    const auto integrate = [&](auto stepper) {
      Position w = body_.spin;
      odeint::integrate_adaptive(stepper, equations, w, 0., body_.time, .1);
      return w;
    };
    for (int digits = 8; digits <= 14; ++digits) {
      const double tolerance = std::pow(10, -digits);
      const std::string suffix = " 1e-" + std::to_string(digits);
      add_peer("odeint Bulirsch–Stoer" + suffix, 1,
               [&] { return integrate(odeint::bulirsch_stoer<Position>(tolerance, tolerance)); });
      add_peer("odeint DOPRI5" + suffix, 1, [&] {
        return integrate(odeint::make_controlled<odeint::runge_kutta_dopri5<Position>>(tolerance, tolerance));
      });
      add_peer("odeint RKF78" + suffix, 1, [&] {
        return integrate(
            odeint::make_controlled<odeint::runge_kutta_fehlberg78<Position>>(tolerance, tolerance));
      });
    }
    add_peer("odeint RK4, h = 0.01", 1, [&] {
      Position w = body_.spin;
      const auto steps = static_cast<std::size_t>(std::lround(body_.time / .01));
      odeint::runge_kutta4<Position> stepper;
      for (std::size_t k = 0; k < steps; ++k)
        stepper.do_step(equations, w, static_cast<double>(k) * .01, .01);
      return w;
    });
  }

  void add_attitude() {
    const auto attitude = TorqueFreeAttitude::make(body_.moments, body_.spin);
    const std::string table = "torque-free attitude";
    AttitudeQuaternion found = attitude->at(body_.time);
    const double error = error_of(found, reference_);
    const double both = nanoseconds(
        [&] {
          keep(body_.spin);
          found = TorqueFreeAttitude::make(body_.moments, body_.spin)->at(body_.time);
          keep(found);
        },
        300);
    add(table, "closed form, set-up and one time", both, error, "set-up included");
    const double one = nanoseconds(
        [&] {
          found = attitude->at(body_.time);
          keep(found);
        },
        300);
    add(table, "closed form, one time", one, error, "set up before");
    const std::vector<double> times(2048, body_.time);
    std::vector<AttitudeQuaternion> turns(times.size());
    const double many = nanoseconds(
                            [&] {
                              attitude->at(times, turns);
                              keep(turns);
                            },
                            1) /
                        2048;
    add(table, "closed form, 2,048 times at once", many, error_of(turns[0], reference_), "set up before");
  }

  const std::string spin_ = "torque-free spin";
  FreeCase body_;
  ReferenceMotion reference_;
  std::vector<KernelRow> rows_;
};

}  // namespace

std::vector<KernelRow> torque_free_rows() { return TorqueFreeRows().run(); }

}  // namespace rigor
