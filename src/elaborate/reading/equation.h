// SPDX-License-Identifier: GPL-3.0-or-later
// What must agree: the terms of a sum, and the sides of a relation.
#pragma once

#include "elaborate/reading/reading.h"
#include "expr/statement/statement.h"

namespace rigor {

/// Where a mismatch is shown, and who is told.
struct Mismatch {
  Span relation;
  Diagnostics& diagnostics;
};

/// Both have one rank and the same free indices, else `mismatch` is told where `other` disagrees. `what` they
/// are: terms or sides.
[[nodiscard]] bool same_type(const Reading& reading, const Typed& first, const Typed& other, const char* what,
                             Mismatch mismatch);

/// The equation left = right, with rank and free indices compared; a literal 0 fits everything.
[[nodiscard]] std::optional<Equation> equate(Reading& reading, const Typed& left, const Typed& right,
                                             Mismatch mismatch);

}  // namespace rigor
