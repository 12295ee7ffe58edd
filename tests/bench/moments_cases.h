// SPDX-License-Identifier: GPL-3.0-or-later
// Principal moments and axes beside the eigensolvers of libraries.
#pragma once

#include <vector>

#include "kernel_rows.h"

namespace rigor {

/// Tables "moments" and "axes": nanoseconds a tensor, 2,048 of a family at once; the worst relative error of
/// a gap or a moment. Remarks: the worst of gaps and of moments. Tables "residual of axes", |A n − λ n| over
/// |A| |n|, infinite for an axis that is not of length 1, and "orthonormality of axes", |n_k·n_l − δ_kl|.
[[nodiscard]] std::vector<KernelRow> moments_rows();

}  // namespace rigor
