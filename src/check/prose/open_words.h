// SPDX-License-Identifier: GPL-3.0-or-later
// Words around a row that may name a condition, without a rule that says so. Where a usual condition makes a
// refuted row true, the words are asked whether they are all neutral: "The vectors include a right angle."
#pragma once

#include <optional>
#include <string>

#include "check/prose/prose.h"

namespace rigor {

/// The first word that is not on the closed list of neutral ones: in the sentence of an event, and in the one
/// before it in the same section.
[[nodiscard]] std::optional<std::string> open_word(const Prose& prose, std::size_t event);

/// "averaging", "incoherent", "the cross terms cancel": of its sentence, or of the sentence directly above
/// it. Terms that are not written may be dropped.
[[nodiscard]] std::optional<std::string> word_of_dropped_terms(const Prose& prose, std::size_t event);

}  // namespace rigor
