// SPDX-License-Identifier: GPL-3.0-or-later
// Space-time: signs of the metric, indices that are lowered, and derivatives by the coordinates of an event.
// A tensor is one symbol with all its indices above; T_μ is σ_μ T^μ, where σ = s·(1, −1, −1, −1) is a table
// and s = η_00 is 1 or −1. Where the notes do not say which, s = η_00/|η_00|, so that what is proved holds
// for both. ∂_μ f has the components (∂_t f/c, ∂_x f, ∂_y f, ∂_z f).
#pragma once

#include "elaborate/reading/reading.h"

namespace rigor {

/// The number s.
[[nodiscard]] ExprId metric_sign(Reading& reading, Span span);
/// σ at the slot; of an axis the sign itself.
[[nodiscard]] ExprId signature_at(Reading& reading, const Slot& slot, Span span);
/// The value with an index lowered, or raised again.
[[nodiscard]] ExprId turned_at(Reading& reading, ExprId value, const Slot& slot, Span span);

/// ∂/∂x^μ at the slot, of a scalar or of components.
[[nodiscard]] ExprId derivative_by_event(Reading& reading, ExprId id, const Slot& slot);
/// `\partial_\mu f`, `\partial^\mu f`
[[nodiscard]] MaybeTyped by_event(Reading& reading, const Typed& operand, const WrittenIndex& index,
                                  Span span, const Around& around);
/// ∂_μ∂^μ f
[[nodiscard]] MaybeTyped box_of(Reading& reading, const Typed& operand, Span span);

/// A slot for a letter or a digit; what is free is added.
[[nodiscard]] std::optional<Slot> event_slot(Reading& reading, const WrittenIndex& index,
                                             const Around& around, std::vector<FreeIndex>& free);

/// `x^\mu = (ct, x, y, z)`: the side that is a whole tensor becomes its component with the letters of the
/// other.
void match_components(Reading& reading, Typed& one, Typed& other);

}  // namespace rigor
