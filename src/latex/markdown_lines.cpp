// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/markdown_lines.h"

#include <algorithm>

#include "latex/ascii.h"
#include "latex/document_display.h"

namespace rigor {
namespace {

constexpr std::size_t fewest_marks = 3;

/// Behind `-`, `*`, `+`, `1.` or `1)` and the blank that must follow; `at` where no list item starts.
std::size_t skip_list_mark(const NotesText& text, std::size_t at) {
  std::size_t end = at;
  while (end < at + 9 && is_digit(text[end])) ++end;
  const bool number = end > at;
  const char mark = text[end];
  const bool is_mark = number ? mark == '.' || mark == ')' : mark == '-' || mark == '*' || mark == '+';
  return is_mark && is_blank(text[end + 1]) ? end + 2 : at;
}

std::size_t skip_run(const NotesText& text, std::size_t at, char mark) {
  while (text[at] == mark) ++at;
  return at;
}

}  // namespace

LineStart line_start(const NotesText& text, std::size_t line) {
  LineStart start{line, 0, false};
  while (true) {
    while (is_blank(text[start.at])) ++start.at;
    const std::size_t item = skip_list_mark(text, start.at);
    if (text[start.at] == '>') {
      ++start.at;
      ++start.quotes;
    } else if (item > start.at) {
      start.at = item;
    } else {
      return start;
    }
    start.marked = true;
  }
}

std::optional<Fence> fence_at(const NotesText& text, std::size_t at) {
  const char mark = text[at];
  if (mark != '`' && mark != '~') return std::nullopt;
  const std::size_t behind = skip_run(text, at, mark);
  if (behind < at + fewest_marks) return std::nullopt;
  const Span info = text.trimmed(behind, text.line_end(behind));
  const std::string_view words = text.between(info.begin, info.end);
  if (mark == '`' && words.find('`') != std::string_view::npos) return std::nullopt;
  const std::string_view first = words.substr(0, words.find_first_of(" \t"));
  return Fence{at, behind - at, first == "math" || first == "{math}"};
}

std::optional<std::size_t> find_fence_end(const NotesText& text, const Fence& fence, std::size_t line,
                                          bool in_paragraph) {
  const char mark = text[fence.begin];
  for (; line < text.size(); line = text.next_line(line)) {
    if (in_paragraph && text.is_blank_line(line)) return std::nullopt;
    std::size_t at = line;
    while (is_blank(text[at]) || text[at] == '>') ++at;
    const std::size_t behind = skip_run(text, at, mark);
    if (behind < at + fence.marks) continue;
    const Span rest = text.trimmed(behind, text.line_end(behind));
    if (rest.empty()) return line;
  }
  return std::nullopt;
}

Span atx_title(const NotesText& text, std::size_t line) {
  std::size_t begin = line;
  while (text[begin] == ' ') ++begin;
  begin = skip_run(text, begin, '#');
  Span title = text.trimmed(begin, text.line_end(line));
  std::size_t end = title.end;
  while (end > title.begin && text[end - 1] == '#') --end;
  if (end == title.begin || is_white(text[end - 1])) title = text.trimmed(title.begin, end);
  return title;
}

int setext_level(const NotesText& text, std::size_t line) {
  std::size_t at = line;
  while (at < line + 3 && text[at] == ' ') ++at;
  const char mark = text[at];
  if (mark != '=' && mark != '-') return 0;
  std::size_t behind = skip_run(text, at, mark);
  if (behind < at + fewest_marks) return 0;
  while (is_blank(text[behind])) ++behind;
  if (behind < text.size() && text[behind] != '\n') return 0;
  return mark == '=' ? 1 : 2;
}

std::size_t paragraph_end(const NotesText& text, std::size_t at) {
  std::size_t line = text.next_line(at);
  while (line < text.size() && !text.is_blank_line(line) && atx_level(text, line) == 0) {
    const std::size_t start = line_start(text, line).at;
    if (text.has("```", start) || text.has("~~~", start)) break;
    line = text.next_line(line);
  }
  return line;
}

std::size_t front_matter_end(const NotesText& text) {
  const auto line_is = [&](std::size_t line, std::string_view what) {
    return text.has(what, line) && text.trimmed(line + what.size(), text.line_end(line)).empty();
  };
  if (!line_is(0, "---") || text.is_blank_line(text.next_line(0))) return 0;
  for (std::size_t line = text.next_line(0); line < text.size(); line = text.next_line(line)) {
    if (line_is(line, "---") || line_is(line, "...")) return text.next_line(line);
  }
  return 0;
}

}  // namespace rigor
