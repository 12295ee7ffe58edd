// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels that run in lanes, as they were compiled for one instruction set. All give the same bits; the
// widest that the machine has is the fastest.
#pragma once

#include <cstddef>
#include <vector>

#include "numeric/kernels/mesh_totals.h"

namespace rigor {

struct LaneKernels {
  const char* instruction_set = "";  // baseline, x86_64_v3 (AVX2, FMA), x86_64_v4 (AVX-512)
  std::size_t lanes = 0;             // doubles at once
  MeshKernels mesh;
};

/// Those that this program was built with and this machine can run, from the narrowest to the widest. Never
/// empty.
[[nodiscard]] const std::vector<const LaneKernels*>& runnable_lane_kernels();

/// The widest of them.
[[nodiscard]] const LaneKernels& lane_kernels();

}  // namespace rigor
