// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/notes_math.h"

#include "latex/layout_reader.h"

namespace rigor {

std::vector<Token> NotesMath::lexed(const std::string& text) {
  const FileId file = sources_.add("", text);
  return lex(sources_, {file, 0, static_cast<std::uint32_t>(sources_.text(file).size())});
}

std::optional<Box> NotesMath::box_of(const std::string& latex) {
  Diagnostics unheard;  // check has reported them
  const auto tokens = expand(lexed(latex), macros_, unheard);
  return tokens ? std::optional(layout_of(*tokens)) : std::nullopt;
}

Box NotesMath::line_of(const std::string& prose) {
  Diagnostics unheard;
  const auto tokens = expand(lexed(prose), macros_, unheard);
  return tokens ? text_box(*tokens, {}) : words_box(prose);
}

}  // namespace rigor
