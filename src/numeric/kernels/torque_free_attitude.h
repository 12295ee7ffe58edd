// SPDX-License-Identifier: GPL-3.0-or-later
// The attitude of a rigid body without torque in closed form, at any time: the turn q that takes components
// along the body's axes at that time to those along the axes at rest with which the body's coincide at the
// time 0, v₀ = q v q*. It solves dq/dt = ½ q ω, ω as in torque_free.h.
//
// Method: angular momentum rests in space, which leaves one angle about it; the angle is linear in the time
// but for the argument of a theta function at a complex phase. The linear rate is a mean over a period, a
// complete elliptic integral of the third kind, in two parts. No axis is singular: L along an axis, on the
// separatrix, tops, rest. Formulas and sources: free_attitude_lanes.h.
//
// Cost on a machine with AVX-512: 1 us for set-up and one time, 3 us where k' < 1/2; 75 to 100 ns a time
// after that, 18 to 25 ns each of many (tests/bench/torque_free_cases.cpp). Error, for the doubles as given:
// 16 u in |q − q'|, 4 u measured, at every time up to 1e8 periods, forwards and backwards
// (torque_free_attitude_test.cpp, 50 digits). The same bits on every machine.
#pragma once

#include <array>
#include <span>

#include "base/result.h"
#include "numeric/kernels/position.h"
#include "numeric/lane/free_bodies.h"

namespace rigor {

/// (w, x, y, z) of length 1, w ≥ 0.
using AttitudeQuaternion = std::array<double, 4>;

class TorqueFreeAttitude {
 public:
  /// As `TorqueFree::make`.
  [[nodiscard]] static Result<TorqueFreeAttitude> make(const Position& moments, const Position& spin);

  /// `time` in s, of any sign. Not a number if it is not, and beyond 2^47 turns.
  [[nodiscard]] AttitudeQuaternion at(double time) const;

  /// The same bits for each of many times; as many attitudes as times.
  void at(std::span<const double> times, std::span<AttitudeQuaternion> into) const;

 private:
  FreeAttitude attitude_;
};

}  // namespace rigor
