// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "latex/token/tokens.h"

namespace rigor {

/// From a place to the end of the tokens after it; the place alone where there are none: they have no place.
[[nodiscard]] inline Span cover(Span first, TokenView rest) {
  return rest.empty() ? first : cover(first, span_of(rest));
}

}  // namespace rigor
