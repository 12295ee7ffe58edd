// SPDX-License-Identifier: GPL-3.0-or-later
// Questions and their answers as bytes, for a file or for another process of the same program.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "expr/statement/closed_question.h"

namespace rigor {

/// The same bytes for the same question. A decision and a sample are those of a closed question.
[[nodiscard]] std::string archived(const ClosedQuestion& question);
[[nodiscard]] std::string archived(const Decision& decision);
[[nodiscard]] std::string archived(const Sample& sample);

/// From bytes that `archived` made; nothing from bytes that are cut short or whose ids name nothing. A
/// question comes back without the notes: its symbols are its own.
[[nodiscard]] std::optional<ClosedQuestion> question_of_bytes(std::string_view bytes);
[[nodiscard]] std::optional<Decision> decision_of_bytes(std::string_view bytes);
[[nodiscard]] std::optional<Sample> sample_of_bytes(std::string_view bytes);

}  // namespace rigor
