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

}  // namespace rigor
