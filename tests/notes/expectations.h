// SPDX-License-Identifier: GPL-3.0-or-later
// What a small note announces in its comments, and where the report on it differs: the rules of README.md.
#pragma once

#include <string>
#include <vector>

#include "check/step/report.h"
#include "source/source_map.h"

namespace rigor {

struct Expectations {
  struct Display {
    Span span;
    std::vector<std::string> verdicts;
    std::vector<std::string> kinds;
  };
  std::vector<Display> displays;  // all of the note, announced or not
  std::vector<std::string> kinds_in_file;
  std::vector<std::string> problems;  // in the comments themselves
};

/// Of a file that is in `sources`.
[[nodiscard]] Expectations read_expectations(SourceMap& sources, FileId file);

/// `PATH:LINE:COLUMN: expected …, got …` for each difference; empty if all is as announced.
[[nodiscard]] std::vector<std::string> differences(const FileReport& report, SourceMap& sources);

/// The same for a note that announces nothing: every step holds and there is no diagnostic.
[[nodiscard]] std::vector<std::string> flaws(const FileReport& report, const SourceMap& sources);

}  // namespace rigor
