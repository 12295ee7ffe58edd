// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "kernel_rows.h"

namespace rigor {

/// A million tensors at the edge of what a body can have; `error` is how many are decided otherwise than in
/// integers.
[[nodiscard]] std::vector<KernelRow> validity_rows();

}  // namespace rigor
