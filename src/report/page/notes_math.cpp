// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/page/notes_math.h"

#include "latex/layout/layout_reader.h"
#include "report/wording/explained.h"

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

Box NotesMath::box_of_printed(const std::string& latex) { return layout_of(lexed(latex)); }

Box NotesMath::rule_of(const std::string& rule) {
  Box line;
  for (const RulePart& part : rule_parts(rule))
    line.parts.push_back(part.is_math ? box_of_printed(part.text) : words_box(part.text));
  return line;
}

Box NotesMath::line_of(const std::string& prose, Format format) {
  if (format == Format::latex) {
    Diagnostics unheard;
    const auto tokens = expand(lexed(prose), macros_, unheard);
    return tokens ? text_box(*tokens, {}) : words_box(prose);
  }
  Box line;
  for (std::size_t at = 0; at <= prose.size();) {
    const std::size_t open = prose.find('$', at);
    const std::size_t close = open == std::string::npos ? open : prose.find('$', open + 1);
    if (close == std::string::npos) {
      line.parts.push_back(words_box(prose.substr(at)));
      break;
    }
    line.parts.push_back(words_box(prose.substr(at, open - at)));
    const std::string latex = prose.substr(open + 1, close - open - 1);
    line.parts.push_back(box_of(latex).value_or(words_box(latex)));
    at = close + 1;
  }
  return line;
}

}  // namespace rigor
