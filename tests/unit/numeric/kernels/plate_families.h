// SPDX-License-Identifier: GPL-3.0-or-later
// Inertia tensors at the edge of what a rigid body can have, and the exact decision.
#pragma once

#include "base/splitmix.h"
#include "numeric/body/body.h"

namespace rigor {

/// Is I₁ + I₂ − I₃ ≥ −4 units in the last place of the greatest entry? That sum is the least eigenvalue of
/// tr(I) 1 − 2I: no principal minor of it with the tolerance added is negative, in integers.
[[nodiscard]] bool is_valid_exactly(const InertiaTensor& inertia);

/// A plate of five points in a plane through integers, with rounded entries, and one of the entries of the
/// diagonal off by up to 12 units in the last place of the greatest.
[[nodiscard]] InertiaTensor nearly_a_plate(SplitMix& bits);

}  // namespace rigor
