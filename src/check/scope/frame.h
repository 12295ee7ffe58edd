// SPDX-License-Identifier: GPL-3.0-or-later
// Two frames with one origin: axes that turn with the angular velocity ω, and fixed ones. The rotation R
// takes components along the turning axes to the fixed axes, and changes at the rate Ṙ = R Ω, Ω_ij = −ε_ijk
// ω_k, which says what ω is. The fixed axes are those with which the turning ones coincide at the moment that
// is looked at (R = 1): another choice turns every component by one constant rotation, which a derivative in
// the fixed frame, taken back to the turning axes, does not see.
#pragma once

#include <optional>
#include <string>

#include "elaborate/name/names.h"

namespace rigor {

/// From here on components are along the turning axes; what held before is turned
/// (check/scope/change_of_axes.h). `angular_velocity`: an expression of rank 1, components along the turning
/// axes. Nothing is declared where the rates that were assumed before are too large to be turned: the result
/// says so. `used` gets the directives that say how what is turned changes.
std::optional<std::string> declare_frame(ExprTree& tree, Names& names, const std::string& rotating,
                                         const std::string& fixed, ExprId angular_velocity,
                                         std::size_t directive, Directives& used);

/// Before a heading of this level closes sections: what equations defined under a frame that ends there is
/// said along fixed axes from here on. `used`: as above.
void leave_frames(ExprTree& tree, Names& names, int level, Directives& used);

}  // namespace rigor
