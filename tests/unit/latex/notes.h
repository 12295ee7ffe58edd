// SPDX-License-Identifier: GPL-3.0-or-later
// Notes as the reader of documents sees them, as text.
#pragma once

#include <string>

#include "latex/document/document.h"
#include "latex/token/token.h"

namespace rigor {

struct ReadNotes {
  SourceMap sources;
  Diagnostics diagnostics;
  Document document;

  ReadNotes(std::string path, std::string text) {
    const FileId file = sources.add(std::move(path), std::move(text));
    document = read_document(sources, file, diagnostics);
  }

  /// One item a line: `h1 Title`, `directive …`, `macro …`, `display <environment> …` with the body's blanks
  /// trimmed.
  [[nodiscard]] std::string dump() const {
    std::string result;
    for (const Item& item : document.items)
      result += std::visit([&](const auto& it) { return line(it); }, item);
    return result;
  }

  /// One diagnostic a line: the line, the text at the place, the message.
  [[nodiscard]] std::string complaints() const {
    std::string result;
    for (const Diagnostic& diagnostic : diagnostics) {
      const auto place = sources.line_column(diagnostic.span.file, diagnostic.span.begin);
      result +=
          std::to_string(place.line) + ":" + std::to_string(place.column) + " " + diagnostic.message + "\n";
    }
    return result;
  }

 private:
  [[nodiscard]] std::string line(const Heading& heading) const {
    return "h" + std::to_string(heading.level) + " " + heading.title + "\n";
  }
  [[nodiscard]] std::string line(const DirectiveLine& directive) const {
    return "directive " + std::string(sources.text(directive.span)) + "\n";
  }
  [[nodiscard]] std::string line(const MacroText& macro) const {
    return (macro.global ? "global macro " : "macro ") + std::string(sources.text(macro.span)) + "\n";
  }
  [[nodiscard]] static std::string line(const MacroGroup& group) { return group.opens ? "{\n" : "}\n"; }
  [[nodiscard]] std::string line(const Display& display) const {
    std::string body(sources.text(display.body));
    while (!body.empty() && (body.front() == ' ' || body.front() == '\n')) body.erase(0, 1);
    while (!body.empty() && (body.back() == ' ' || body.back() == '\n')) body.pop_back();
    return "display <" + display.environment + "> " + body + "\n";
  }
};

inline std::string latex(std::string text) { return ReadNotes("notes.tex", std::move(text)).dump(); }
inline std::string markdown(std::string text) { return ReadNotes("notes.md", std::move(text)).dump(); }
inline std::string latex_complaints(std::string text) {
  return ReadNotes("notes.tex", std::move(text)).complaints();
}
inline std::string markdown_complaints(std::string text) {
  return ReadNotes("notes.md", std::move(text)).complaints();
}

}  // namespace rigor
