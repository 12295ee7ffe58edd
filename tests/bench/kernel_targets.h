// SPDX-License-Identifier: GPL-3.0-or-later
// What the kernels must reach beside their peers.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "kernel_rows.h"

namespace rigor {

struct KernelTarget {
  std::string what;
  std::string wanted;
  std::string measured;
  bool met = false;
};

/// Ratios of times are those of the sums over the families that are named, so that none counts by its name
/// alone. A table without rows misses its targets.
[[nodiscard]] std::vector<KernelTarget> kernel_targets(std::span<const KernelRow> rows);

}  // namespace rigor
