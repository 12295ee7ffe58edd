// SPDX-License-Identifier: GPL-3.0-or-later
// The text of one file of notes, and the questions about it that need no knowledge of where a reader stands.
// Places are offsets of bytes; a place past the end reads as a NUL byte.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

#include "latex/text/format.h"
#include "latex/text/items.h"
#include "source/source_map.h"

namespace rigor {

/// `\begin{name}` or `\end{name}`.
struct EnvironmentMark {
  std::string_view name;  // blanks trimmed
  std::size_t end = 0;    // after the brace
};

class NotesText {
 public:
  NotesText(const SourceMap& sources, FileId file, Format format)
      : text_(sources.text(file)), file_(file), format_(format) {}

  [[nodiscard]] std::size_t size() const { return text_.size(); }
  [[nodiscard]] char operator[](std::size_t at) const { return at < text_.size() ? text_[at] : '\0'; }
  [[nodiscard]] std::string_view between(std::size_t begin, std::size_t end) const {
    return text_.substr(begin, end - begin);
  }
  [[nodiscard]] bool has(std::string_view what, std::size_t at) const;
  [[nodiscard]] std::size_t find(std::string_view what, std::size_t at) const { return text_.find(what, at); }
  [[nodiscard]] Span span(std::size_t begin, std::size_t end) const;
  /// The span without the white space at both ends.
  [[nodiscard]] Span trimmed(std::size_t begin, std::size_t end) const;
  [[nodiscard]] Format format() const { return format_; }

  /// The letters after the backslash at `at`; empty for a control symbol.
  [[nodiscard]] std::string_view control_word(std::size_t at) const;
  /// The name in braces from `at` on; nothing where none follows on this line.
  [[nodiscard]] std::optional<EnvironmentMark> environment_mark(std::size_t at) const;

  /// The line break, or the end of the text.
  [[nodiscard]] std::size_t line_end(std::size_t at) const;
  /// The start of the next line; the end of the text in the last line.
  [[nodiscard]] std::size_t next_line(std::size_t at) const;
  /// The line that starts here is empty but for blanks and, in Markdown, for the marks of a quotation.
  [[nodiscard]] bool is_blank_line(std::size_t line) const;
  /// The start of the first blank line that starts after `at`; the end of the text without one.
  [[nodiscard]] std::size_t blank_line(std::size_t at) const;
  /// The start of the line after that blank line.
  [[nodiscard]] std::size_t after_blank_line(std::size_t at) const { return next_line(blank_line(at)); }
  /// After blanks, comments (LaTeX) and at most one line break; never into a blank line.
  [[nodiscard]] std::size_t skip_gap(std::size_t at) const;

  /// From `at` on the prose goes on with "and cyclic permutations", "etc." or the like.
  [[nodiscard]] bool goes_on_cyclically(std::size_t at) const;

  /// After the brace that closes the one at `open`; nothing where none does. After eight braces that were
  /// closed nowhere, every search ends at a blank line: a file of open braces is not read to its end for each
  /// of them.
  [[nodiscard]] std::optional<std::size_t> group_end(std::size_t open, bool in_paragraph = false);
  /// After the `]` that closes the `[` at `open`, before the next blank line.
  [[nodiscard]] std::optional<std::size_t> bracket_end(std::size_t open) const;

 private:
  std::string_view text_;
  FileId file_;
  Format format_;
  int open_groups_ = 0;
};

}  // namespace rigor
