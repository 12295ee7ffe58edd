// SPDX-License-Identifier: GPL-3.0-or-later
// One step of many rigid bodies without torque, each with its own moments, spin, attitude and time, in closed
// form: for simulators that split (kick by the torque, free turn, kick).
//
//   I₁ dω₁/dt = (I₂ − I₃) ω₂ ω₃ and cyclic,  dq/dt = ½ q ω;  I, ω along the body's principal axes, kg m² and
//   rad/s; q as in torque_free_attitude.h.
//
// Method and sources: free_step_lanes.h, for steps of up to 0.7 rad of |ω| t at least, 1.5 rad at most.
// Longer ones go through TorqueFree and TorqueFreeAttitude, one at a time.
#pragma once

#include <cstddef>

#include "numeric/lane/free_bodies.h"
#include "numeric/lane/lane_kernels.h"

namespace rigor {

/// Moves each of the bodies; moments in any order, as for `TorqueFree::make`. Of bodies that it refuses, and
/// where the time or the attitude is not finite or the time beyond 2^47 turns, spin and attitude become not a
/// number; their number is returned. Attitudes are of length 1 to 4 u after it, with either sign.
std::size_t step_free_bodies(const FreeBodies& bodies, const LaneKernels& kernels = lane_kernels());

}  // namespace rigor
