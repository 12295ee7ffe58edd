// SPDX-License-Identifier: GPL-3.0-or-later
// What the attitude of a free rigid body is at any time, as numbers that the lane kernels read: see
// torque_free_attitude.h, and free_attitude_lanes.h for the formulas. Only built-in types.
#pragma once

#include "numeric/lane/free_spin.h"

namespace rigor {

struct FreeAttitude {
  FreeSpin spin;
  double moment[3] = {};     // along the standard frame, in any unit; of a steady spin its direction
  double turn_rate[2] = {};  // A/π over `spin.scale`, high + low; of a steady spin ω/2π
  double turn = 0;           // η'/π: the turn of half a half period (hyperbolic)
  double cosine[2] = {};     // cosh η, cosh 2η (circular); cos η', cos 2η' (hyperbolic)
  double sine[2] = {};       // likewise
  bool about_zero = false;  // circular: θ₁(v − iη) stands for θ₄(v + i(η* − η)), η* = −½ ln q
  double last[2] = {};      // q¹², 4 q²: of the last term of θ₃
  double start[4] = {1, 0, 0, 0};  // at the time 0 from the body's axes to those about L
};

}  // namespace rigor
