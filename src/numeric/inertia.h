// SPDX-License-Identifier: GPL-3.0-or-later
// Mass, centre of mass and inertia tensor of a body, each on its own. Its principal moments and axes:
// kernels/principal_moments.h.
#pragma once

#include "numeric/body.h"

namespace rigor {

/// kg.
[[nodiscard]] double total_mass(const Body& body);
[[nodiscard]] Result<Position> centre_of_mass(const Body& body);

/// About the body's centre of mass, along its axes; two passes. Cost: O(N). Error: about N u relative to the
/// greatest entry at worst, √N u as a rule. Fails where a body is invalid or a sum overflows.
[[nodiscard]] Result<InertiaTensor> inertia_tensor(const Body& body);

}  // namespace rigor
