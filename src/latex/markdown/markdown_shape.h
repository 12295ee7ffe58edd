// SPDX-License-Identifier: GPL-3.0-or-later
// A Markdown text as its blocks see it. CommonMark knows neither displays nor the containers of other
// dialects: a line `- c` inside `$$ … $$` would begin a list, and the content of MyST's `{note}` would be
// code. So lines of displays are covered, lines that only open or close a container become blank, and marks
// of containers with indented content become those of a list. The number of lines stays: blocks have the
// lines of the text.
#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace rigor {

class MarkdownShape {
 public:
  explicit MarkdownShape(std::string_view text);

  [[nodiscard]] std::size_t line_count() const { return lines_.size(); }
  /// The line opens or closes a container, or is not shown. False: it is blank already.
  bool blank(std::size_t line);
  /// The line begins a container whose other lines are indented by four, as in `!!! note`, `[^1]: …`. False:
  /// it was made one before.
  bool make_item(std::size_t line);
  /// These lines are those of displays after their first one, and no others.
  bool cover(std::set<std::size_t> lines);
  [[nodiscard]] bool is_covered(std::size_t line) const { return covered_.contains(line); }
  /// The line could begin a block, or end a paragraph.
  [[nodiscard]] bool could_matter(std::size_t line) const;

  [[nodiscard]] std::string text() const;

 private:
  std::vector<std::string> lines_;  // without what stands only for links, emphasis and the like
  std::set<std::size_t> items_;     // made so far
  std::set<std::size_t> covered_;
};

}  // namespace rigor
