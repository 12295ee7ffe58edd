// SPDX-License-Identifier: GPL-3.0-or-later
// What the page says not to hold: "Students often write", "but this is wrong", "This fails at high speeds."
// next to a display. It defines nothing, and nothing follows from it.
#pragma once

#include <optional>
#include <string>

#include "check/prose/prose.h"

namespace rigor {

/// The word that denies the display at `event`: in its own clause, after it in its sentence, or in the next
/// sentence if that points back to it. Cost: linear in the number of sentences.
[[nodiscard]] std::optional<std::string> denial_of(const Prose& prose, std::size_t event);

}  // namespace rigor
