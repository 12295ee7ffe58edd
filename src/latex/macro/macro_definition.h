// SPDX-License-Identifier: GPL-3.0-or-later
// What each command that defines a macro looks like, and how a definition becomes an entry of a MacroTable.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "latex/macro/macro_stream.h"
#include "latex/macro/macros.h"

namespace rigor {

/// The arguments that follow the command.
enum class DefinitionForm : std::uint8_t {
  command,            // \newcommand*{\x}[n][default]{body}
  provided_command,   // \providecommand*{\x}[n][default]{body}: an older definition stays
  document_command,   // \NewDocumentCommand{\x}{O{default} m m}{body}
  primitive,          // \def\x#1#2{body}
  synonym,            // \let\x=\y
  math_operator,      // \DeclareMathOperator*{\x}{name}
  delimiters,         // \DeclarePairedDelimiter{\x}{left}{right}
  delimiters_around,  // \DeclarePairedDelimiterX{\x}[n]{left}{right}{body}
};

/// The form that a control opens (`newcommand`); nothing for a control that defines no macro.
[[nodiscard]] std::optional<DefinitionForm> definition_form(std::string_view control);

/// Reads what follows `control` and enters it in `macros`. A definition that is not read is `bad_macro`, and
/// so is every later call of its name: an older meaning would be a guess. False: where the definition ends is
/// not known.
bool read_definition(const Token& control, DefinitionForm form, MacroStream& stream, MacroTable& macros,
                     Diagnostics& diagnostics);

}  // namespace rigor
