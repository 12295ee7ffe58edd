// SPDX-License-Identifier: GPL-3.0-or-later
// Moments of meshes beside what programs write.
#pragma once

#include <vector>

#include "kernel_rows.h"

namespace rigor {

/// Table "mesh": nanoseconds a triangle on the first mesh of a family (20,000 triangles or more), the worst
/// error of the family: of the volume, of the centre relative to each coordinate or to √(ii), or of the
/// second moments about the centre relative to their norm, which remarks tell apart. Infinite for a failure,
/// a wrong sign of the volume and a second moment that is not positive.
[[nodiscard]] std::vector<KernelRow> mesh_rows();

}  // namespace rigor
