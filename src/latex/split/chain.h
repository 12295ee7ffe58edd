// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "latex/split/split.h"
#include "latex/token/accounting.h"

namespace rigor {

/// `a = b = c` cut at the relations outside all brackets; punctuation at the ends of sides goes.
[[nodiscard]] WrittenChain chain_of(TokenView tokens, TokenUses& uses);

/// Without blanks at both ends and without empty groups `{}` at the end, unless they are somebody's argument.
[[nodiscard]] TokenView without_empty_end(TokenView tokens);

}  // namespace rigor
