// SPDX-License-Identifier: GPL-3.0-or-later
// The motion of a spin: dω/dt = f(ω), components along axes fixed in the body, and the orientation that
// follows from it. Which f is for others to say (`spin_law.h`). Method: Runge–Kutta–Fehlberg 7(8) of
// Boost.odeint with its own choice of steps; the rows are met exactly, nothing is interpolated. Time and spin
// are scaled by the size of the first spin, so that units and the speed of the motion do not matter to the
// tolerance.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace rigor {

using Vector3 = std::array<double, 3>;

/// (w, x, y, z) of length 1; turns components along the body's axes into those along fixed axes.
using Quaternion = std::array<double, 4>;

/// q v q*, a vector's components along the fixed axes.
[[nodiscard]] Vector3 turned(const Quaternion& orientation, const Vector3& along_body);

/// `inner` first.
[[nodiscard]] Quaternion composed(const Quaternion& outer, const Quaternion& inner);

/// That turns the unit vectors to these, which are a right-handed orthonormal triple.
[[nodiscard]] Quaternion turn_to(const std::array<Vector3, 3>& axes);

/// Rates of change of the components in 1/s². Not a number: the law does not determine them there.
using SpinRates = std::function<Vector3(const Vector3& spin)>;

struct MotionRequest {
  Vector3 spin{};       // at the time 0, in rad/s
  double duration = 0;  // in s; negative: backwards
  std::size_t rows = 501;
  double tolerance = 1e-10;  // of one step, relative to the size of the first spin; 1e-15 to 1e-2
  std::optional<Quaternion> orientation = {};  // at the time 0; none: not asked for
  std::size_t most_evaluations = 2'000'000;    // of the rates: where the integration gives up
};

struct Motion {
  std::vector<double> times;             // of the rows, in s
  std::vector<Vector3> spins;            // one a row
  std::vector<Quaternion> orientations;  // one a row if asked for, else none
  std::size_t steps = 0;
  std::size_t evaluations = 0;
  std::string stopped;                     // why it ended before its time; empty: it did not
  bool closed_form = false;                // no steps: see free_motion.h
  std::optional<double> split_order = {};  // of steps that are split, as measured: see split_motion.h
};

/// Never hangs and never throws; a motion that stops has the rows until then. Values of the request that are
/// not finite, or no row, stop it at once.
[[nodiscard]] Motion integrate(const SpinRates& rates, const MotionRequest& request);

}  // namespace rigor
