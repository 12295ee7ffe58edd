// SPDX-License-Identifier: GPL-3.0-or-later
// What the spin of a free rigid body is at any time, as numbers that the lane kernels read: see
// torque_free.h for the body, torque_free_lanes.h for the formulas. Only built-in types.
#pragma once

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

}  // namespace rigor
