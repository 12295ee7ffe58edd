// SPDX-License-Identifier: GPL-3.0-or-later
// Principal moments of a symmetric tensor together with their gaps, and the principal axes.
//
// Euler's equations and the frequencies of a top depend on the differences of the moments, and a difference
// of rounded moments has lost what they have in common: near a symmetric top, all digits. So the gaps are
// results of their own.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "base/result.h"
#include "numeric/kernels/high_low.h"
#include "numeric/kernels/position.h"
#include "numeric/lane/lane_kernels.h"
#include "numeric/lane/moments_columns.h"

namespace rigor {

/// Of a moment as high + low, relative to the greatest entry or moment: `proved_rounding` of b, of which the
/// entries are at most twice as great, and the last rounding.
inline constexpr double moments_error = 0x1p-90;

struct EnclosedGap {
  double value = 0;
  double error = 0;
};

/// Each moment as one double; the bounds are those of `PrincipalMoments`.
struct RoundedMoments {
  Position moments{};            // ascending
  std::array<double, 2> gaps{};  // I₂ − I₁, I₃ − I₂

  /// I_i − I_j with its sign, without cancellation; indices from 0.
  [[nodiscard]] double gap(std::size_t i, std::size_t j) const;
};

/// Of a symmetric 3×3 tensor a, in its unit. The textbook: the roots λ of det(a − λ 1) = 0 and their
/// differences.
///
/// Error of each gap and each moment, relative to itself: at most 16 u in every family that is tested, also
/// where entries differ by hundreds of powers of ten (tensor_extremes_test.cpp); exactly 0 where the result
/// is 0, and nowhere else. Results below 2^-1022 have the absolute error of their last place. Measured: 7.1 u
/// for a gap, 3.3 u for a moment. As high + low the moments err by 61 v |a|, v = 2^-106, in all that was
/// tried, and by `moments_error` |a| at most: that is proved (moments_proof_test.cpp).
/// Of a gap above 2^-38 |a| it is 2 u, to which the roundings of its own root and sums come.
struct PrincipalMoments {
  SharpPosition moments{};       // ascending
  std::array<double, 2> gaps{};  // I₂ − I₁, I₃ − I₂

  [[nodiscard]] RoundedMoments rounded() const {
    return {{moments[0].high, moments[1].high, moments[2].high}, gaps};
  }
  /// I_i − I_j to a bound of its error that is proved; of gaps above 2^-37 of the greatest moment, 4 u of
  /// them.
  [[nodiscard]] EnclosedGap enclosed_gap(std::size_t i, std::size_t j) const {
    const HighLow found = moments[i] - moments[j];
    const double greatest =
        std::max({std::abs(moments[0].high), std::abs(moments[1].high), std::abs(moments[2].high)});
    return {found.high, (std::abs(found.low) + 2 * moments_error * greatest) * (1 + 0x1p-50) + 0x1p-1070};
  }
};

/// The axes are orthonormal to 10 u and right-handed; the first two point to where their component of
/// greatest size is positive. Error of an axis: 6 u, also where its moment is close to another; where two
/// moments are exactly equal, their axes are some orthonormal choice. |a n − λ n| ≤ 5 u |a|. Measured: 8.6,
/// 4.4 and 2 u.
struct PrincipalAxes {
  PrincipalMoments principal;
  std::array<Position, 3> axes{};  // unit vectors in the order of the moments
};

/// One tensor; only its lower triangle is read. Method: `moments_lanes.h`; where that does not do, exact
/// invariants, and then rotations in as many digits as it takes (`moments_exact.h`). Cost: 0.2 us; 0.5 us;
/// from 40 us on. Moments of doubles that lie apart, by 2^-9 of their deviations at least, take 0.07 us
/// (`distinct_moments_lanes.h`); the bits are the same. Fails where an entry is not finite, or a moment or a
/// gap overflows.
[[nodiscard]] Result<RoundedMoments> principal_moments(const InertiaTensor& tensor);
[[nodiscard]] Result<PrincipalMoments> principal_moments(const SharpTensor& tensor);
[[nodiscard]] Result<PrincipalAxes> principal_axes(const InertiaTensor& tensor);
[[nodiscard]] Result<PrincipalAxes> principal_axes(const SharpTensor& tensor);

/// Many tensors. `state` says what became of each: `good`, `mended`, or `none`, with NaN for all results.
/// Cost: 37 ns a tensor in lanes of 8, 41 ns with axes (49 and 57 in lanes of 4, 137 and 148 in lanes of 2);
/// bodies of revolution in any attitude 65 and 70 ns (83 and 92, 245 and 270); a single one 0.2 us. The bits
/// depend neither on the instruction set nor on the place of a tensor.
void solve_principal_moments(const MomentsColumns& columns, const LaneKernels& kernels = lane_kernels());

}  // namespace rigor
