// SPDX-License-Identifier: GPL-3.0-or-later
// From point masses to the frequencies of a wobbling top.
#pragma once

#include <vector>

#include "kernel_rows.h"

namespace rigor {

/// Table "points to stability frequency": nanoseconds from 1,024 point masses to (Ω_1)², (Ω_2)², (Ω_3)², and
/// the worst relative error of the three. An infinite one has the wrong sign.
[[nodiscard]] std::vector<KernelRow> stability_rows();

}  // namespace rigor
