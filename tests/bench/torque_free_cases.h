// SPDX-License-Identifier: GPL-3.0-or-later
// The motion of a free rigid body: the closed form beside Boost's elliptic functions and integrators.
#pragma once

#include <vector>

#include "kernel_rows.h"

namespace rigor {

/// Tables "torque-free spin" and "torque-free attitude": time a result (least of many runs), error of ω over
/// |ω| or of the quaternion, against 70 digits. Some 20 seconds.
[[nodiscard]] std::vector<KernelRow> torque_free_rows();

}  // namespace rigor
