// SPDX-License-Identifier: GPL-3.0-or-later
// The lines around a wrong one: a term that is missing in it may stand there.
#pragma once

#include <vector>

#include "check/event/notes.h"
#include "latex/token/tokens.h"

namespace rigor {

/// The sides of a few chains before and behind this one, which is one of the notes. They are views into them.
[[nodiscard]] std::vector<TokenView> sides_near(const Notes& notes, const ParsedChain& parsed);

}  // namespace rigor
