// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace rigor {

/// Symmetric tensors by columns: of each tensor the diagonal a_ii, and a_jk for the cyclic (i, j, k); low
/// parts, or none of them. What is not asked for is null: low parts of the moments, all axes. `state` is 0
/// where all results are good; else the sum of 1 for a gap and 2 for moments too small beside the rounding
/// errors, or 4 where nothing is known. In and out may not overlap.
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

}  // namespace rigor
