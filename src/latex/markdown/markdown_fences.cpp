// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/markdown/markdown_fences.h"

#include <algorithm>

#include "base/ascii.h"
#include "latex/markdown/markdown_lines.h"
#include "latex/token/words.h"

namespace rigor {
namespace {

/// `note` in `{note} A title`; `note` in `note`; `callout-note` in `{.callout-note}` keeps its point.
std::string_view first_word(std::string_view words) {
  words = without_blanks_around(words);
  if (words.starts_with('{')) {
    words.remove_prefix(1);
    words = words.substr(0, words.find('}'));
  }
  return without_blanks_around(words).substr(0, without_blanks_around(words).find_first_of(" \t,;"));
}

/// Languages of code cells, and directives that hold no Markdown.
bool is_code(std::string_view name) {
  static const WordSet codes(
      "asy asymptote autoclass autofunction automodule bash bibliography block c cat code code-block "
      "code-cell comment contents cpp css csv-table digraph doctest dot embed eval-rst fortran go graph "
      "graphviz haskell highlight html iframe image include java javascript js jsx julia latex "
      "literalinclude lua make mathematica matlab mermaid node octave ojs perl php plantuml plot prolog "
      "prompt py pyodide python r raw Rcpp R ruby rust sage sas scala scheme sh sourcecode sql stan "
      "tableofcontents testcode testoutput tex tikz toctree toc ts typescript video webr wolfram yaml zsh");
  return codes.contains(name);
}

bool is_option(std::string_view line) {
  const std::size_t end = line.starts_with(':') ? line.find(':', 1) : std::string_view::npos;
  return end != std::string_view::npos && end > 1 &&
         line.substr(1, end - 1).find_first_of(" \t\\{") == std::string_view::npos;
}

std::string_view line_text(const NotesText& text, std::size_t line) {
  const std::size_t begin = line_start(text, line).at;
  return without_blanks_around(text.between(begin, std::max(begin, text.line_end(line))));
}

}  // namespace

FenceContent content_of_fence(std::string_view words) {
  words = without_blanks_around(words);
  const std::string_view name = first_word(words);
  if (name == "math") return FenceContent::math;
  if (!words.starts_with('{') || name.empty()) return FenceContent::code;
  if (name == "=latex" || name == "=tex")
    return FenceContent::markdown;  // Pandoc puts it into the document as it is
  const bool attribute = name[0] == '.' || name[0] == '#' || name[0] == '=';
  return attribute || is_code(name) ? FenceContent::code : FenceContent::markdown;
}

FenceContent content_of_colons(std::string_view words) {
  const std::string_view name = first_word(words);
  if (name == "math") return FenceContent::math;
  return is_code(name) ? FenceContent::code : FenceContent::markdown;
}

std::optional<ColonMark> colon_mark_at(const NotesText& text, std::size_t at) {
  std::size_t behind = at;
  while (text[behind] == ':') ++behind;
  if (behind < at + 3) return std::nullopt;
  ColonMark mark{behind - at, behind, false};
  while (is_blank(text[mark.words])) ++mark.words;
  mark.closes = mark.words >= text.size() || text[mark.words] == '\n';
  return mark;
}

std::optional<std::size_t> find_colon_end(const NotesText& text, std::size_t line, std::size_t colons,
                                          std::size_t limit) {
  for (; line < limit; line = text.next_line(line)) {
    const auto mark = colon_mark_at(text, line_start(text, line).at);
    if (mark && mark->closes && mark->colons >= colons) return line;
  }
  return std::nullopt;
}

std::size_t behind_options(const NotesText& text, std::size_t line, std::size_t end) {
  if (line < end && line_text(text, line) == "---") {
    for (std::size_t next = text.next_line(line); next < end; next = text.next_line(next)) {
      if (line_text(text, next) == "---") return text.next_line(next);
    }
    return line;
  }
  while (line < end && is_option(line_text(text, line))) line = text.next_line(line);
  return line;
}

bool begins_indented_content(const NotesText& text, std::size_t at) {
  for (const std::string_view mark : {"!!! ", "!!!+ ", "??? ", "???+ ", "=== \"", "===! \"", "===+ \""}) {
    if (text.has(mark, at)) return true;
  }
  if (text[at] == ':' && is_blank(text[at + 1])) return true;
  if (!text.has("[^", at)) return false;
  const std::string_view line = text.between(at, text.line_end(at));
  const std::size_t close = line.find(']');
  return close != std::string_view::npos && close > 2 && close + 1 < line.size() && line[close + 1] == ':';
}

}  // namespace rigor
