// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "numeric/kernels/principal_moments.h"

namespace rigor {

/// A body that spins freely with ω about its principal axis i, pushed a little, wobbles with the frequency
/// Ω_i:
///
///   (Ω_i)² = ω² (I_i − I_j)(I_i − I_k)/(I_j I_k),  i, j, k all different
///
/// so that it is stable where this is positive, and −(Ω_i)² is the square of its rate of growth where it is
/// negative. rad²/s² for ω in rad/s; the axes in the order of the moments. Error: each at most 40 u of
/// itself, whatever the gaps, because they are taken from `principal` and not from its moments; measured: 7
/// u. A moment of 0 (a thin rod) gives infinity, or NaN where it is the axis of two equal ones. No product
/// overflows where the result does not.
[[nodiscard]] std::array<double, 3> squared_stability_frequencies(const RoundedMoments& principal,
                                                                  double spin);

}  // namespace rigor
