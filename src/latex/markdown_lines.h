// SPDX-License-Identifier: GPL-3.0-or-later
// What the lines of Markdown are, one at a time: quotations, list items, fences, headings.
// Source: CommonMark 0.31, except that lines indented by four blanks are text: in lists they mostly are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "latex/document_text.h"

namespace rigor {

struct LineStart {
  std::size_t at = 0;        // behind blanks, marks of quotations and of list items
  std::uint32_t quotes = 0;  // marks `>`
  bool marked = false;       // there was a mark of either sort
};
[[nodiscard]] LineStart line_start(const NotesText& text, std::size_t line);

struct Fence {
  std::size_t begin;
  std::size_t marks;  // how many, at least three
  bool math;          // ```math
};
/// The fence that opens at `at`, where a line's own text starts.
[[nodiscard]] std::optional<Fence> fence_at(const NotesText& text, std::size_t at);
/// The start of the line that closes the fence, from the line `line` on; `in_paragraph`: before a blank line.
[[nodiscard]] std::optional<std::size_t> find_fence_end(const NotesText& text, const Fence& fence,
                                                        std::size_t line, bool in_paragraph);

/// The title in `## Title ##`.
[[nodiscard]] Span atx_title(const NotesText& text, std::size_t line);
/// 1 for a line `===`, 2 for `---`, 0 for others. A heading only under a line of text.
[[nodiscard]] int setext_level(const NotesText& text, std::size_t line);

/// The start of the line behind `at` that ends the paragraph: a blank line, a fence or a heading.
[[nodiscard]] std::size_t paragraph_end(const NotesText& text, std::size_t at);
/// Behind `---` … `---` at the start of the text.
[[nodiscard]] std::size_t front_matter_end(const NotesText& text);

}  // namespace rigor
