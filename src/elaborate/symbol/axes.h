// SPDX-License-Identifier: GPL-3.0-or-later
// Subscripts that are index letters or axes, also primed ones. Components are along the unprimed axes;
// \lambda_{i'j} = e_i'·e_j carries them to the primed ones.
#pragma once

#include "elaborate/reading/reading.h"

namespace rigor {

struct Subscript {
  std::vector<Slot> slots = {};
  std::vector<FreeIndex> free = {};
};

/// Nothing where one is neither an index letter nor an axis.
[[nodiscard]] std::optional<Subscript> try_subscript(Reading& reading, const std::vector<WrittenIndex>& axes,
                                                     const Around& around);
/// The same, with a diagnostic.
[[nodiscard]] std::optional<Subscript> subscript(Reading& reading, const std::vector<WrittenIndex>& axes,
                                                 Span span, const Around& around);

/// An index variable: no digit, no x, y, z.
[[nodiscard]] bool is_index_letter(const WrittenIndex& axis);
[[nodiscard]] bool any_primed(const std::vector<WrittenIndex>& axes);
/// The component of a vector or tensor along primed (and other) axes: A_i' = λ_i'a A_a.
[[nodiscard]] MaybeTyped along_axes(Reading& reading, Typed whole, const std::vector<WrittenIndex>& axes,
                                    Span span, const Around& around);
/// `\lambda_{i'j}` and `\lambda_{ji'}` are the same cosine; where no prime is written in all of a statement,
/// the first index is the primed one. `typed` is all of it but its node.
[[nodiscard]] MaybeTyped direction_cosine(Reading& reading, const ExprNode& node,
                                          const std::vector<WrittenIndex>& axes, Typed typed, Span span,
                                          const Around& around);

[[nodiscard]] Typed basis_vector(Reading& reading, Span span, Slot slot, std::vector<FreeIndex> free);
/// e_i' has the components λ_i'1, λ_i'2, λ_i'3.
[[nodiscard]] MaybeTyped primed_basis_vector(Reading& reading, const WrittenIndex& axis, Span span,
                                             const Around& around);
/// δ or ε. Between primed and unprimed axes, δ is the direction cosine.
[[nodiscard]] MaybeTyped unit_tensor(Reading& reading, const WrittenSymbol& written, Span span,
                                     const Around& around);

}  // namespace rigor
