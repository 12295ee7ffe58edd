// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace rigor {

/// What is known of a tensor's results; numbers, as they are in a column of doubles.
struct MomentsState {
  static constexpr double good = 0;
  // From the lane kernel, and nowhere else: what is too small compared with the rounding errors. Both: their
  // sum.
  static constexpr double small_gap = 1;
  static constexpr double small_moment = 2;
  static constexpr double lost = 4;  // nothing is known
  // From `solve_principal_moments`:
  static constexpr double mended = 8;  // good, and more than the kernel was needed
  static constexpr double none = 16;   // there are no results
};

/// Symmetric tensors by columns: of each tensor the diagonal a_ii, and a_jk for the cyclic (i, j, k). Low
/// parts are null, or none of them is; so are low parts of the moments, and the axes: what is not asked for.
/// In and out may not overlap.
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
  double* state = nullptr;  // `MomentsState`
};

}  // namespace rigor
