// SPDX-License-Identifier: GPL-3.0-or-later
// How far a macro definition reaches in the text of notes. What it says is read by `expand`, from the tokens.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "latex/macro/macro_definition.h"
#include "latex/text/document_text.h"
#include "latex/token/environments.h"

namespace rigor {

struct DefinitionExtent {
  std::size_t end = 0;
  std::string_view name = {};  // the control, without its backslash, or environment; empty: none follows
  OwnBodies bodies = {};       // of a command or \def the opening only
  std::optional<std::size_t> open = {};  // the brace or bracket that is not closed
};

/// `at` is after the command. A definition that breaks off ends where it does.
[[nodiscard]] DefinitionExtent definition_extent(NotesText& text, DefinitionForm form, std::size_t at);

enum class EnvironmentForm : std::uint8_t {
  bodies,     // \newenvironment{name}[n][default]{begin}{end}
  arguments,  // \NewDocumentEnvironment{name}{m m}{begin}{end}
  one_body,   // \NewEnviron{name}[n][default]{begin \BODY end}
};
/// The form that a control opens; nothing for a control that defines no environment.
[[nodiscard]] std::optional<EnvironmentForm> environment_form(std::string_view control);
/// The same for environments.
[[nodiscard]] DefinitionExtent environment_definition_extent(NotesText& text, EnvironmentForm form,
                                                             std::size_t at);

}  // namespace rigor
