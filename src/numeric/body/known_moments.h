// SPDX-License-Identifier: GPL-3.0-or-later
// Principal moments to any digits of bodies whose sums in double-double do not tell two of them apart.
#pragma once

#include <functional>

#include "numeric/body/body.h"
#include "numeric/exact/exact_tensor.h"

namespace rigor {

/// Does a tensor that is known to `error` of each entry leave less than six bits of a gap between its
/// moments, as they are found in double-double?
[[nodiscard]] bool may_have_equal_moments(const SharpTensor& tensor, double error);

/// Puts in the exact moments of a tensor where those of what is known may be equal; costs 1 us elsewhere.
void tell_moments_apart(KnownInertia& known, const std::function<std::optional<ExactTensor>()>& exact);

/// The same, and puts in the body in integers.
void tell_moments_apart(KnownInertia& known, const ExactBody& exact);

}  // namespace rigor
