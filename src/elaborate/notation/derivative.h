// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives by the time, in a frame and along a motion, by coordinates and by letters.
#pragma once

#include "elaborate/reading/reading.h"

namespace rigor {

/// By `x`, `y`, `z`, `x_i` or `r_i`, as a place.
[[nodiscard]] MaybeTyped by_coordinate(Reading& reading, const Typed& operand, const WrittenSymbol& variable,
                                       Span span, const Around& around);
/// x, y, z, `x_i`, `r_i`: a place, unless the section shows that it is a variable of its own.
[[nodiscard]] bool is_place(const Reading& reading, const WrittenSymbol& variable);
/// May a letter below the bracket around this say what is held? It is no index there.
[[nodiscard]] bool may_hold_by_name(const Reading& reading, SyntaxId id);
/// `\left(\frac{\partial S}{\partial T}\right)_V`.
[[nodiscard]] MaybeTyped held_derivative(Reading& reading, SyntaxId id, const WrittenIndex& held,
                                         const Around& around);
/// `y''` and `V'(r)`, where the section says that V is a function of this variable.
[[nodiscard]] MaybeTyped primed_derivative(Reading& reading, const WrittenSymbol& written,
                                           const std::string& variable, Span span, const Around& around);
/// `\left(\frac{d\mathbf A}{dt}\right)_{\text{in}}`. In the fixed frame it is taken of the components along
/// fixed axes: (dA/dt)_in = Rᵀ d(R A)/dt, with the rotation R of `frame` (see check/scope/frame.h).
[[nodiscard]] MaybeTyped frame_derivative(Reading& reading, SyntaxId id, const Frame& frame, bool fixed,
                                          const Around& around);
/// Df/Dt = ∂f/∂t + (u·∇)f along an unknown motion u: what holds for every u is proved, and nothing is
/// refuted.
[[nodiscard]] MaybeTyped material_rate(Reading& reading, SyntaxId operand, Span span, const Around& around);

}  // namespace rigor
