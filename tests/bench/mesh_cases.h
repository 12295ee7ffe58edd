// SPDX-License-Identifier: GPL-3.0-or-later
// Moments of meshes beside what programs write.
#pragma once

#include <vector>

#include "kernel_rows.h"

namespace rigor {

/// Table "mesh": nanoseconds a triangle on the first mesh of a family (20,000 triangles or more), the error
/// of the second moments about the centre relative to their norm, worst of the family.
[[nodiscard]] std::vector<KernelRow> mesh_rows();

}  // namespace rigor
