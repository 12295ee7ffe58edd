// SPDX-License-Identifier: GPL-3.0-or-later
// Mass, centre and inertia of points beside the obvious code and beside a plain read of the same bytes.
#pragma once

#include <vector>

#include "kernel_rows.h"

namespace rigor {

/// Table `inertia of points, time`: nanoseconds a point for 1,024 points and more, in the first and second
/// cache and in memory. Table `inertia of points, error`: the worst error of each method in each family of
/// 1,000 points, relative to the greatest entry, for the exact inputs.
[[nodiscard]] std::vector<KernelRow> mass_sums_rows();

}  // namespace rigor
