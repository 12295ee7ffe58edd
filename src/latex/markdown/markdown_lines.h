// SPDX-License-Identifier: GPL-3.0-or-later
// What the lines of Markdown are, one at a time, where `markdown_blocks` has said to which block they belong.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "latex/text/document_text.h"

namespace rigor {

struct LineStart {
  std::size_t at = 0;        // after blanks, marks of quotations and of list items
  std::uint32_t quotes = 0;  // marks `>`
  bool marked = false;       // there was a mark of either sort
};
[[nodiscard]] LineStart line_start(const NotesText& text, std::size_t line);

struct Fence {
  std::size_t begin;
  std::size_t marks;  // how many, at least three
};
/// The fence that opens at `at`, where a line's own text starts.
[[nodiscard]] std::optional<Fence> fence_at(const NotesText& text, std::size_t at);
/// The line closes the fence.
[[nodiscard]] bool closes_fence(const NotesText& text, const Fence& fence, std::size_t line);

/// The title in `## Title ##`.
[[nodiscard]] Span atx_title(const NotesText& text, std::size_t line);
/// After `---` … `---` at the start of the text.
[[nodiscard]] std::size_t front_matter_end(const NotesText& text);

/// The HTML element that opens at `at`, if it shows what is inside as it is typed, or not at all: `pre`,
/// `code`, `script`, `style`, `textarea`. Empty for others.
[[nodiscard]] std::string_view raw_element_at(const NotesText& text, std::size_t at);
/// Where `closing`, as `</pre`, is between the places, in letters of any size; npos if nowhere.
[[nodiscard]] std::size_t find_element_end(const NotesText& text, std::string_view closing, std::size_t from,
                                           std::size_t until);

/// Where each line of a text starts.
class LineStarts {
 public:
  explicit LineStarts(const NotesText& text);
  [[nodiscard]] std::size_t count() const { return starts_.size() - 1; }
  /// The end of the text for lines after the last one.
  [[nodiscard]] std::size_t operator[](std::size_t line) const {
    return starts_[std::min(line, starts_.size() - 1)];
  }
  [[nodiscard]] std::size_t line_at(std::size_t offset) const;

 private:
  std::vector<std::size_t> starts_;
};

}  // namespace rigor
