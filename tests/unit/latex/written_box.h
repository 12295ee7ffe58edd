// SPDX-License-Identifier: GPL-3.0-or-later
// What is typed as MathML and as plain text, for tests.
#pragma once

#include <string>

#include "latex/layout/mathml.h"
#include "latex/layout/plain_text.h"
#include "latex/token/token.h"

namespace rigor {

inline Tokens tokens_of(SourceMap& sources, const std::string& text) {
  const FileId file = sources.add("note.tex", text);
  return lex(sources, {file, 0, static_cast<std::uint32_t>(text.size())});
}

inline std::string mathml_of(const std::string& text) {
  SourceMap sources;
  const std::string all = to_mathml(tokens_of(sources, text), MathStyle::inline_);
  const std::size_t begin = all.find('>') + 1;
  return all.substr(begin, all.size() - begin - std::string("</math>").size());
}

inline std::string plain_of(const std::string& text) {
  SourceMap sources;
  return to_plain_text(tokens_of(sources, text));
}

inline ShownDisplay display_of(const std::string& text, std::string_view environment = {}) {
  SourceMap sources;
  return layout_of_display(tokens_of(sources, text), environment);
}

/// Every element is closed in its order, and nothing but elements, texts and the five entities stands there.
inline bool is_well_formed(std::string_view xml) {
  std::vector<std::string> open;
  for (std::size_t at = 0; at < xml.size();) {
    if (xml[at] == '&') {
      const std::size_t end = xml.find(';', at);
      if (end == std::string_view::npos || end - at > 6) return false;
      at = end + 1;
      continue;
    }
    if (xml[at] != '<') {
      if (static_cast<unsigned char>(xml[at]) < 0x20) return false;
      ++at;
      continue;
    }
    const std::size_t end = xml.find('>', at);
    if (end == std::string_view::npos) return false;
    std::string_view inside = xml.substr(at + 1, end - at - 1);
    if (inside.find('<') != std::string_view::npos) return false;
    at = end + 1;
    if (inside.starts_with('/')) {
      if (open.empty() || open.back() != inside.substr(1)) return false;
      open.pop_back();
    } else {
      open.emplace_back(inside.substr(0, inside.find(' ')));
    }
  }
  return open.empty();
}

}  // namespace rigor
