// SPDX-License-Identifier: GPL-3.0-or-later
// Free rigid bodies as numbers that the lane kernels read. Of one body what its spin and its attitude are at
// any time: see torque_free.h and torque_free_attitude.h, and torque_free_lanes.h and free_attitude_lanes.h
// for the formulas. Of many bodies their state: torque_free_step.h. Only built-in types.
#pragma once

#include <cstddef>

namespace rigor {

enum class FreeSpinKind : int {
  steady,      // the spin rests in the body
  circular,    // complementary modulus at least 1/2: series in the nome q
  hyperbolic,  // below, down to the separatrix: series in the complementary nome q'
};

struct FreeSpin {
  FreeSpinKind kind = FreeSpinKind::steady;
  double spin[3] = {};  // at the time 0
  double scale = 1;     // a power of two: the unit of rates

  // The standard frame (J₁, J₂, J₃): J₂ is the middle moment, and L's path in the body encloses axis 3.
  int axis[3] = {0, 1, 2};
  double sign[3] = {1, 1, 1};  // of the axes: right-handed, and ω₁, ω₃ ≥ 0 at the time 0

  // The phase as high + low, at the time 0 and its rate over `scale`: over π, of v = π u / 2K (circular); of
  // v' = π u / 2K' (hyperbolic), which is reduced by its half period L = π K / K' (inverse 0: separatrix).
  double start[2] = {};
  double rate[2] = {};
  double half_period[2] = {};
  double inverse_half_period = 0;

  double nome = 0;           // q or q'
  double root_nome = 0;      // √q'
  double amplitude[3] = {};  // rad/s, over `scale` in a FreeAttitude, with the signs
  double theta3[4] = {};     // θ₃ = t₀ + t₂ G² + G (t₁ + t₃ G²) at G = 2 q cos 2v; θ₄ at −G
  double theta2[4] = {};     // θ₂ / (2 q^¼ cos v), likewise; θ₁ / (2 q^¼ sin v) at −G
};

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

/// The state of many bodies by columns, components along each body's principal axes. Attitudes take
/// components along the body's axes to those along axes at rest. Columns may not overlap.
struct FreeBodies {
  std::size_t count = 0;
  const double* moments[3] = {};
  double* spin[3] = {};
  double* attitude[4] = {};       // w, x, y, z
  const double* times = nullptr;  // in s, how long each moves; null: `time` for all
  double time = 0;
};

}  // namespace rigor
