// SPDX-License-Identifier: GPL-3.0-or-later
// How a row was read, line by line: what the text and the page both print.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "check/shown/read_row.h"
#include "source/source_map.h"

namespace rigor {

enum class ReadingPart : std::uint8_t {
  written,
  read_as,
  role,
  not_read,
  help,
  letters,
  convention,
  also_read_as,
  restricted,
  rests_on,
};

/// `by convention` and so on.
[[nodiscard]] std::string_view heading_of(ReadingPart part);

struct ReadingLine {
  ReadingPart part = ReadingPart::written;
  std::string latex = {};   // the row, a letter, or what it rests on
  std::string words = {};   // all else; of what it rests on, its name
  std::string source = {};  // of a letter: what says so, and where
};

/// In their order. `row` is one of `report`.
[[nodiscard]] std::vector<ReadingLine> reading_lines(const ReadRow& row, const FileReport& report,
                                                     const SourceMap& sources);

}  // namespace rigor
