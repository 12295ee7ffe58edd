// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/markdown/markdown_lines.h"

#include <array>

#include "base/ascii.h"

namespace rigor {
namespace {

constexpr std::size_t fewest_marks = 3;

/// After `-`, `*`, `+`, `1.` or `1)` and the blank that must follow; `at` where no list item starts.
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

/// In letters of any size; `name` has small ones.
bool has_name(const NotesText& text, std::string_view name, std::size_t at) {
  for (const char letter : name) {
    if ((text[at++] | 0x20) != letter) return false;
  }
  return true;
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
  return Fence{at, behind - at};
}

bool closes_fence(const NotesText& text, const Fence& fence, std::size_t line) {
  if (line <= fence.begin) return false;
  const char mark = text[fence.begin];
  std::size_t at = line;
  while (is_blank(text[at]) || text[at] == '>') ++at;
  const std::size_t behind = skip_run(text, at, mark);
  return behind >= at + fence.marks && text.trimmed(behind, text.line_end(behind)).empty();
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

std::string_view raw_element_at(const NotesText& text, std::size_t at) {
  static constexpr auto elements =
      std::to_array<std::string_view>({"pre", "script", "style", "textarea", "code"});
  for (const std::string_view name : elements) {
    const char behind = text[at + 1 + name.size()];
    if (text[at] == '<' && has_name(text, name, at + 1) && (behind == '>' || is_white(behind))) return name;
  }
  return {};
}

std::size_t find_element_end(const NotesText& text, std::string_view closing, std::size_t from,
                             std::size_t until) {
  for (std::size_t at = text.find("</", from); at < until; at = text.find("</", at + 1)) {
    if (has_name(text, closing.substr(2), at + 2)) return at;
  }
  return std::string_view::npos;
}

LineStarts::LineStarts(const NotesText& text) {
  for (std::size_t at = 0; at < text.size(); at = text.next_line(at)) starts_.push_back(at);
  starts_.push_back(text.size());
}

std::size_t LineStarts::line_at(std::size_t offset) const {
  const auto behind = std::upper_bound(starts_.begin(), starts_.end() - 1, offset);
  return behind == starts_.begin() ? 0 : static_cast<std::size_t>(behind - starts_.begin()) - 1;
}

}  // namespace rigor
