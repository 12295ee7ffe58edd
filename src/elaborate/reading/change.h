// SPDX-License-Identifier: GPL-3.0-or-later
// How what was read changes: with the time, along an axis, under ∇.
#pragma once

#include "elaborate/reading/reading.h"
#include "latex/token/vocabulary.h"

namespace rigor {

/// The derivative by the time. A partial one holds the position.
[[nodiscard]] Typed rate_of(Reading& reading, Typed typed, int times = 1, bool partial = false);
/// The derivative by a letter.
[[nodiscard]] Typed derivative_by(Reading& reading, Typed typed, const Variable& by);
/// ∂/∂x_s of each component.
[[nodiscard]] ExprId derivative_along(Reading& reading, ExprId id, Slot axis);

/// A vector changes in its own way in every frame: a diagnostic where two are in force.
[[nodiscard]] bool frame_is_open(Reading& reading, const Typed& typed, Span span);
/// d/dt of a field follows the motion, only ∂/∂t is a free symbol: a diagnostic for the former.
[[nodiscard]] bool is_total_rate_of_field(Reading& reading, const Typed& typed, Span span);
/// A partial rate holds the place, also that in a definition: U = r² does not change by itself.
[[nodiscard]] MaybeTyped with_places_open(Reading& reading, Typed typed, Span span);

/// (∇f)_i = ∂_i f, (∇A)_ij = ∂_i A_j, ∇·A = ∂_i A_i, (∇×A)_i = ε_ijk ∂_j A_k, ∇²A = ∂_i ∂_i A.
[[nodiscard]] bool has_other_places(Reading& reading, Span span);
[[nodiscard]] MaybeTyped apply_nabla(Reading& reading, FieldOperator what, const Typed& operand, Span span);
/// (A·∇)X = A_i ∂_i X
[[nodiscard]] MaybeTyped directional(Reading& reading, const Typed& along, const Typed& operand, Span span);

}  // namespace rigor
