// SPDX-License-Identifier: GPL-3.0-or-later
// A hole, `\square`: a symbol that no name belongs to, of the shape that the reading gives it.
#pragma once

#include "elaborate/reading/reading.h"

namespace rigor {

/// Letters on the hole itself are its own; other subscripts only name it.
[[nodiscard]] MaybeTyped elaborate_hole(Reading& reading, const WrittenSymbol& written, Span span,
                                        const Around& around);

}  // namespace rigor
