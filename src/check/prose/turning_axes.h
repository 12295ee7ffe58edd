// SPDX-License-Identifier: GPL-3.0-or-later
// "In the rotating frame with axes $\mathbf e_i$": the axes turn, and basis vectors have rates. Without such
// words they are read as fixed.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "check/prose/prose.h"

namespace rigor {

/// The word that says so, in a sentence or a heading of the section of an event and of those around it, above
/// it or below. Cost: linear in the sentences.
[[nodiscard]] std::optional<std::string> word_of_turning_axes(const Prose& prose, std::size_t event,
                                                              const std::string& heading);

}  // namespace rigor
