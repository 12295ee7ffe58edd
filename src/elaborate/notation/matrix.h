// SPDX-License-Identifier: GPL-3.0-or-later
// Tuples, matrices, determinants and traces.
#pragma once

#include "elaborate/reading/reading.h"

namespace rigor {

/// Of a second-rank tensor, or of what is at `id` with two free indices: row by row, each entry read with
/// the indices at its place.
[[nodiscard]] MaybeTyped determinant_of(Reading& reading, SyntaxId id, const Typed& inside, Span span,
                                        const Around& around);
[[nodiscard]] MaybeTyped trace_or_determinant(Reading& reading, SyntaxId id, bool trace,
                                              const Around& around);

// --- adjoint.cpp

/// `A^\dagger` of a matrix, column or row with known entries.
[[nodiscard]] MaybeTyped adjoint_of(Reading& reading, const Typed& matrix, Span span);
/// `A^*`, unless the star can be an adjoint.
[[nodiscard]] MaybeTyped conjugate_of_matrix(Reading& reading, const Typed& matrix, Span span);
/// `[A, B]` and `\{A, B\}` where a matrix is in it; nothing where it is a pair of something else.
[[nodiscard]] std::optional<MaybeTyped> commutator(Reading& reading, SyntaxId id, const Around& around);

}  // namespace rigor
