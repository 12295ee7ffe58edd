// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/markdown/markdown_shape.h"

#include <algorithm>
#include <utility>

namespace rigor {
namespace {

constexpr std::string_view leading = " \t>-+*_=#`~0123456789.):";
constexpr std::string_view inline_marks = "`*_[]!\\&\"'~";

/// With letters for all signs that mean something only inside a paragraph.
std::string bared(std::string_view line) {
  std::string result(line);
  std::size_t at = std::min(line.find_first_not_of(leading), line.size());
  const bool tick = line.find('`', at) != std::string_view::npos;
  if (tick)
    std::replace(result.begin(), result.begin() + static_cast<std::ptrdiff_t>(at), '`', 'x');  // no fence
  if (at < line.size() && line[at] == '<') {
    if (line.substr(at).starts_with("<![CDATA[")) return result;
    at = std::min(at + (line.substr(at).starts_with("<!") ? 4 : 1), line.size());  // `<!--`
  }
  for (; at < result.size(); ++at) {
    const bool closes_element = result[at] == '<' && at + 1 < result.size() && result[at + 1] == '/';
    if ((result[at] == '<' && !closes_element) || inline_marks.find(result[at]) != std::string_view::npos)
      result[at] = 'x';
  }
  return result;
}

}  // namespace

MarkdownShape::MarkdownShape(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines_.push_back(bared(text.substr(at, end - at)));
    at = end + 1;
  }
}

bool MarkdownShape::blank(std::size_t line) {
  return line < lines_.size() && !std::exchange(lines_[line], std::string()).empty();
}

bool MarkdownShape::make_item(std::size_t line) {
  if (!items_.insert(line).second) return false;
  std::string& text = lines_[line];
  const std::size_t begin = text.find_first_not_of(" \t>");
  if (begin == std::string::npos) return false;
  text = text.substr(0, begin) + "-   x" + (text.size() > begin + 4 ? text.substr(begin + 4) : "");
  return true;
}

bool MarkdownShape::cover(std::set<std::size_t> lines) {
  if (lines == covered_) return false;
  covered_ = std::move(lines);
  return true;
}

bool MarkdownShape::could_matter(std::size_t line) const {
  const std::string& text = lines_[line];
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string::npos) return true;
  const char first = text[begin];
  return begin >= 4 || first == '<' || (leading.find(first) != std::string_view::npos && first != ')');
}

std::string MarkdownShape::text() const {
  std::string result;
  auto covered = covered_.begin();
  for (std::size_t line = 0; line < lines_.size(); ++line) {
    const bool hidden = covered != covered_.end() && *covered == line;
    if (hidden) ++covered;
    result += hidden ? "x" : lines_[line];
    result += '\n';
  }
  return result;
}

}  // namespace rigor
