// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled once for each instruction set, which CMakeLists.txt names.
#include "numeric/lane/lane_kernels.h"

#include "numeric/lane/distinct_moments_lanes.h"
#include "numeric/lane/free_attitude_lanes.h"
#include "numeric/lane/free_spin_lanes.h"
#include "numeric/lane/free_step_lanes.h"
#include "numeric/lane/lanes.h"
#include "numeric/lane/mesh_sums_lanes.h"
#include "numeric/lane/moments_lanes.h"
#include "numeric/lane/sharp_mass_sums_lanes.h"
#include "numeric/lane/torque_free_lanes.h"

#define RIGOR_NAME_OF(x) #x
#define RIGOR_NAME(x) RIGOR_NAME_OF(x)

namespace rigor::RIGOR_INSTRUCTION_SET {

extern const LaneKernels kernels;
const LaneKernels kernels = {
    .instruction_set = RIGOR_NAME(RIGOR_INSTRUCTION_SET),
    .lanes = lanes,
    .mesh = mesh_kernels,
    .principal_moments = principal_moments_kernel,
    .principal_moments_of_one = principal_moments_of_one,
    .distinct_moments = rounded_distinct_moments,
    .sum_points = sum_points,
    .sum_points_sharply = sum_points_sharply,
    .sample_points = sample_points,
    .set_free_spin =
        [](const double* moments, const double* spin, FreeSpin& into) {
          StandardFrame frame;
          set_free_spin(moments, spin, into, frame);
          apply_scale(into);
        },
    .free_spin_at = [](const FreeSpin& spin, double time, double* into) { free_spin_at(spin, time, into); },
    .free_spins_at = [](const FreeSpin& spin, const double* times, std::size_t count,
                        double* into) { free_spins_at(spin, times, count, into); },
    .set_free_attitude = [](const double* moments, const double* spin,
                            FreeAttitude& into) { set_free_attitude(moments, spin, into); },
    .attitude_at = [](const FreeAttitude& attitude, double time,
                      double* into) { attitude_at<double>(attitude, time, into); },
    .attitudes_at = [](const FreeAttitude& attitude, const double* times, std::size_t count,
                       double* into) { attitudes_at(attitude, times, count, into); },
    .step_free_bodies = [](const FreeBodies& bodies,
                           std::size_t* beyond) { return step_free_bodies(bodies, beyond); },
};

}  // namespace rigor::RIGOR_INSTRUCTION_SET
