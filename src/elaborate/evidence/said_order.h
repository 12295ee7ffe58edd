// SPDX-License-Identifier: GPL-3.0-or-later
// Words that say how letters are multiplied: "do not commute", "let $G$ be a group", "$a$ and $b$ are
// matrices", "in floating-point arithmetic".
#pragma once

#include <string_view>

#include "elaborate/evidence/evidence.h"

namespace rigor {

/// Adds what the words of a section say. Where they say that something does not commute, or speak of a group,
/// any letter may be an element of it; where they name another arithmetic, nothing counts as proved for it.
void see_said_order(std::string_view text, Evidence& evidence);

}  // namespace rigor
