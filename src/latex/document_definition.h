// SPDX-License-Identifier: GPL-3.0-or-later
// How far a macro definition reaches in the text of notes. What it says is read by `expand`, from the tokens.
#pragma once

#include <cstddef>
#include <optional>

#include "latex/document_text.h"
#include "latex/macro_definition.h"

namespace rigor {

struct DefinitionExtent {
  std::size_t end = 0;
  std::string_view name = {};     // the control, without its backslash, or environment; empty: none follows
  std::string_view body = {};     // of a command or \def without parameters, without its braces
  std::string_view opening = {};  // of a command or \def with or without parameters, or of `\begin{name}`
  std::optional<std::size_t> open = {};  // the brace or bracket that is not closed
};

/// `at` is behind the command. A definition that breaks off ends where it does.
[[nodiscard]] DefinitionExtent definition_extent(NotesText& text, DefinitionForm form, std::size_t at);
/// The same for `\newenvironment{name}[n][default]{begin}{end}`.
[[nodiscard]] DefinitionExtent environment_definition_extent(NotesText& text, std::size_t at);

}  // namespace rigor
