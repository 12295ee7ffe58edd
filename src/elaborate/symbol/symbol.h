// SPDX-License-Identifier: GPL-3.0-or-later
// A decorated letter: which symbol it is, and whether it is meant whole, as a component, or as a length.
#pragma once

#include "elaborate/reading/reading.h"

namespace rigor {

[[nodiscard]] MaybeTyped elaborate_symbol(Reading& reading, const WrittenSymbol& written, Span span,
                                          const Around& around);

}  // namespace rigor
