// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of point masses before they are summed: whether a body has them, how far they reach, and
// about where their centre is. Points that have no mass count for nothing, however far they are.
#pragma once

#include "base/result.h"
#include "numeric/kernels/point_pass.h"

namespace rigor {

/// Fails, naming the point (from 1), for what is not finite and for negative masses; where there is no mass.
[[nodiscard]] Result<void> check_points(const PointColumns& points);

/// Of points that are checked. The scale takes their greatest distance along an axis from the first of them
/// to between 1 and 2, as far as no coordinate goes beyond 2^901, and the greatest mass to between 2^960 and
/// 2^961, so that light points keep their digits: sums about a centre among 2^24 points stay below 2^990.
struct PointReach {
  PointScale scale;
  bool coincident = false;
};
[[nodiscard]] PointReach reach_of(const PointColumns& points);

/// The mean of up to 128 points spread over the array, in scaled lengths; where those have no mass, or their
/// sums overflow, the first point that has one. It need not be good, only the same on every machine and among
/// the points that have a mass.
[[nodiscard]] SharpPosition sampled_centre(const PointColumns& points, const PointScale& scale);

}  // namespace rigor
