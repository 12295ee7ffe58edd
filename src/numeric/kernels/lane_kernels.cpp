// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled once for each instruction set, which CMakeLists.txt names.
#include "numeric/kernels/lane_kernels.h"

#include "numeric/kernels/lanes.h"
#include "numeric/kernels/mesh_sums_lanes.h"
#include "numeric/kernels/moments_lanes.h"
#include "numeric/kernels/sharp_mass_sums_lanes.h"

#define RIGOR_NAME_OF(x) #x
#define RIGOR_NAME(x) RIGOR_NAME_OF(x)

namespace rigor::RIGOR_INSTRUCTION_SET {

extern const LaneKernels kernels;
const LaneKernels kernels = {
    .instruction_set = RIGOR_NAME(RIGOR_INSTRUCTION_SET),
    .lanes = lanes,
    .mesh = mesh_kernels,
    .principal_moments = principal_moments_kernel,
    .sum_points = sum_points,
    .sum_points_sharply = sum_points_sharply,
    .sample_points = sample_points,
};

}  // namespace rigor::RIGOR_INSTRUCTION_SET
