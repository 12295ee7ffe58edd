// SPDX-License-Identifier: GPL-3.0-or-later
// One step of many free bodies: the kernel beside the closed form for all times and integrators by columns.
#pragma once

#include <vector>

#include "kernel_rows.h"

namespace rigor {

/// Table "torque-free step": time a body, error of the spin over |ω| or of the quaternion in one step,
/// against 70 digits. Some 10 seconds.
[[nodiscard]] std::vector<KernelRow> torque_free_step_rows();

}  // namespace rigor
