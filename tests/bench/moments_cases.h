// SPDX-License-Identifier: GPL-3.0-or-later
// Principal moments and axes beside the eigensolvers of libraries.
#pragma once

#include <vector>

#include "kernel_rows.h"

namespace rigor {

/// Tables "moments" and "axes": nanoseconds a tensor, 2,048 of a family at once; the worst relative error of
/// a gap or a moment. Remarks: the worst of gaps and of moments, and for axes the residual |A n − λ n| in u
/// |A|.
[[nodiscard]] std::vector<KernelRow> moments_rows();

}  // namespace rigor
