// SPDX-License-Identifier: GPL-3.0-or-later
// One step of many rigid bodies without torque, each with its own moments, spin, attitude and time, in closed
// form: for simulators that split (kick by the torque, free turn, kick).
//
//   I₁ dω₁/dt = (I₂ − I₃) ω₂ ω₃ and cyclic,  dq/dt = ½ q ω;  I, ω along the body's principal axes, kg m² and
//   rad/s; q as in torque_free_attitude.h.
//
// Method and sources: free_step_lanes.h, for every step of |ω| t < 0.7 of a body that obeys the triangle
// inequality, whose moments are within 2^200 of each other and none of whose numbers is beyond 2^±1000; for
// most up to 1, spheres up to 1.5. Others go through TorqueFree and
// TorqueFreeAttitude, one at a time.
//
// Cost: 17 to 19 ns a body in lanes of 8, 26 to 28 in lanes of 4, 53 to 58 in lanes of 2, from cache and from
// memory (tests/bench/torque_free_step_cases.cpp); 2 to 3 us for a longer step.
// Error of a step, for the doubles as given: of the component ωᵢ 16 u (|ωᵢ| + |t (Iⱼ − Iₖ)/Iᵢ ωⱼωₖ|), 8 u in
// |q − q'|, the product with the first attitude included (torque_free_step_test.cpp, 70 digits). Most in
// climbs of 30,000 steps: 10.6 and 5.9 u. Longer steps have the errors of torque_free.h and
// torque_free_attitude.h, and 4 u of the product. Over n steps errors add up at random: after 1e6 of 64
// bodies, |ω| t from 0.01 to 0.7, the direction of L in space was off by 0.6 √n u in the median and 2.7 √n u
// at most; its length and the energy by 1.5 √n u in the median and 30 √n u, 3e-12, at most. The same bits on
// every machine.
#pragma once

#include <cstddef>

#include "numeric/lane/free_bodies.h"
#include "numeric/lane/lane_kernels.h"

namespace rigor {

/// Moves each of the bodies; moments in any order, as for `TorqueFree::make`. Of bodies that it refuses, and
/// where the time is not finite or beyond 2^47 turns, spin and attitude become not a number; their number is
/// returned. Attitudes are of length 1 to 4 u after it, of either sign, and not a number where they were.
std::size_t step_free_bodies(const FreeBodies& bodies, const LaneKernels& kernels = lane_kernels());

}  // namespace rigor
