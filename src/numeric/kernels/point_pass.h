// SPDX-License-Identifier: GPL-3.0-or-later
// One pass of a lane kernel over all points: chunks, threads, and scaling by powers of two.
#pragma once

#include "numeric/kernels/mass_sums.h"
#include "numeric/lane/lane_kernels.h"

namespace rigor {

/// Coordinates are multiplied by 2^length on the way in, masses by 2^mass.
struct PointScale {
  int length = 0;
  int mass = 0;

  [[nodiscard]] bool is_one() const { return length == 0 && mass == 0; }
};

[[nodiscard]] PointPlaces places_of(const PointColumns& points);

/// `centre` is in scaled lengths. Chunks are summed by up to `threads` threads and combined in their order,
/// so that the result does not depend on `threads`; where the system gives fewer, those do the work. Scaled
/// points are copied chunk by chunk, those without a mass to the origin.
[[nodiscard]] PointSums point_pass(SumPoints sum, const PointColumns& points, const PointScale& scale,
                                   const SharpPosition& centre, std::size_t threads);

}  // namespace rigor
