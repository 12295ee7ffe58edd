// SPDX-License-Identifier: GPL-3.0-or-later
// Two frames with one origin: axes that turn with the angular velocity ω, and fixed ones. The rotation
// R(q)_ij = ((q_0² − q·q) δ_ij + 2 q_i q_j − 2 q_0 ε_ijk q_k)/(q_0² + q·q) takes components along the turning
// axes to the fixed axes, and the quaternion changes at the rate q' = q ω/2. The fixed axes are those with
// which the turning ones coincide at the moment that is looked at (q = 1): another choice turns every
// component by one constant rotation, which a derivative in the fixed frame, taken back to the turning axes,
// does not see.
#pragma once

#include <optional>
#include <string>

#include "elaborate/names.h"

namespace rigor {

/// `angular_velocity`: an expression of rank 1, components along the turning axes. Nothing is declared where
/// the rates of vectors that were assumed before are too large to be taken over: the result says so.
std::optional<std::string> declare_frame(ExprTree& tree, Names& names, const std::string& rotating,
                                         const std::string& fixed, ExprId angular_velocity,
                                         std::size_t directive);

}  // namespace rigor
