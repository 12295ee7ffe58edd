// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels that run in lanes, as they were compiled for one instruction set. All give the same bits; the
// widest that the machine has is the fastest.
#pragma once

#include <cstddef>
#include <vector>

#include "numeric/kernels/mesh_totals.h"
#include "numeric/kernels/point_sums.h"

namespace rigor {

/// Symmetric tensors by columns: of each tensor the diagonal a_ii, and a_jk for the cyclic (i, j, k); low
/// parts, or none of them. What is not asked for is null: low parts of the moments, all axes. `state` is 1
/// where the results may be wrong, else 0. In and out may not overlap.
struct MomentsColumns {
  std::size_t count = 0;
  const double* diagonal[3] = {};
  const double* off[3] = {};
  const double* diagonal_low[3] = {};
  const double* off_low[3] = {};
  double* moments[3] = {};
  double* moments_low[3] = {};
  double* gaps[2] = {};
  double* axes[3][3] = {};
  double* state = nullptr;
};

struct LaneKernels {
  const char* instruction_set = "";  // baseline, x86_64_v3 (AVX2, FMA), x86_64_v4 (AVX-512)
  std::size_t lanes = 0;             // doubles at once
  MeshKernels mesh;                  // mesh_sums_lanes.h
  void (*principal_moments)(const MomentsColumns&) = nullptr;  // moments_lanes.h
  SumPoints sum_points = nullptr;
  SumPoints sum_points_sharply = nullptr;
  SamplePoints sample_points = nullptr;
};

/// Those that this program was built with and this machine can run, from the narrowest to the widest. Never
/// empty.
[[nodiscard]] const std::vector<const LaneKernels*>& runnable_lane_kernels();

/// The widest of them.
[[nodiscard]] const LaneKernels& lane_kernels();

}  // namespace rigor
