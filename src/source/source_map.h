// SPDX-License-Identifier: GPL-3.0-or-later
// The texts that were read, by FileId, and the line and column of every byte in them.
// A text never moves once added: a std::string_view into it lives as long as the map. No id, span or line is
// wrong: beyond the map there is an empty file, and a span is cut at the end of the text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/span.h"

namespace rigor {

struct LineColumn {
  std::uint32_t line = 1;    // from 1
  std::uint32_t column = 1;  // from 1, in code points
  friend constexpr bool operator==(const LineColumn&, const LineColumn&) = default;
};

class SourceMap {
 public:
  FileId add(std::string path, std::string text);
  /// A text that stands in no file, such as a definition that a configuration says in its own form.
  std::string_view keep(std::string text) { return kept_.emplace_back(std::move(text)); }

  /// How many texts there are; their ids count from 0.
  [[nodiscard]] std::size_t size() const { return files_.size(); }
  [[nodiscard]] const std::string& path(FileId file) const;
  [[nodiscard]] std::string_view text(FileId file) const;
  [[nodiscard]] std::string_view text(Span span) const;
  /// The place of a byte; the end of the text counts as a place, and what is beyond it is the end. A byte
  /// inside a code point has that code point's place. Cost: a binary search and at most two blocks of 4 KiB,
  /// whatever the line's length.
  [[nodiscard]] LineColumn line_column(FileId file, std::uint32_t offset) const;
  /// The byte where a line (from 1) starts; past the last line, the size of the text.
  [[nodiscard]] std::uint32_t line_start(FileId file, std::uint32_t line) const;
  /// One line without its line break.
  [[nodiscard]] std::string_view line_text(FileId file, std::uint32_t line) const;
  /// Line breaks plus one: after a last line break there is one more, empty line.
  [[nodiscard]] std::uint32_t line_count(FileId file) const;

 private:
  struct File {
    std::string path;
    std::string text;
    std::vector<std::uint32_t> line_starts;
    std::vector<std::uint32_t> code_points;  // before each block of 4 KiB
  };
  /// The file, or an empty one for an id beyond the map.
  [[nodiscard]] const File& at(FileId file) const;
  [[nodiscard]] static std::uint32_t code_points_between(const File& file, std::uint32_t begin,
                                                         std::uint32_t end);
  [[nodiscard]] static std::uint32_t code_points_before(const File& file, std::uint32_t offset);

  std::deque<File> files_;
  std::deque<std::string> kept_;
};

}  // namespace rigor
