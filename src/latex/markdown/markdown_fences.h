// SPDX-License-Identifier: GPL-3.0-or-later
// What the fences and containers of Markdown's dialects hold: ```` ```math ````, MyST's ```` ```{note} ````,
// `:::{note}`, `::: warning`, `!!! tip`, `[^1]: …`.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "latex/text/document_text.h"

namespace rigor {

enum class FenceContent : std::uint8_t { math, markdown, code };

/// By the words after the marks. A name in braces is a directive of MyST, unless it is that of a language or
/// of a directive that holds code.
[[nodiscard]] FenceContent content_of_fence(std::string_view words);
/// The same after colons, where a name needs no braces and nothing at all is Markdown, too.
[[nodiscard]] FenceContent content_of_colons(std::string_view words);

/// The line `:::…` at `at`, where its own text starts.
struct ColonMark {
  std::size_t colons = 0;
  std::size_t words = 0;  // after the colons and blanks
  bool closes = false;    // no words
};
[[nodiscard]] std::optional<ColonMark> colon_mark_at(const NotesText& text, std::size_t at);
/// The start of the line that closes what `colons` colons have opened, from `line` on.
[[nodiscard]] std::optional<std::size_t> find_colon_end(const NotesText& text, std::size_t line,
                                                        std::size_t colons, std::size_t limit);

/// After the options of a directive, from its first line on: `:label: x`, or lines between `---` and `---`.
[[nodiscard]] std::size_t behind_options(const NotesText& text, std::size_t line, std::size_t end);

/// A line that begins a container with indented content: `!!! note`, `??? tip`, `=== "Tab"`, `[^1]: …`, `:
/// …`.
[[nodiscard]] bool begins_indented_content(const NotesText& text, std::size_t at);

}  // namespace rigor
