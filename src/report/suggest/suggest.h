// SPDX-License-Identifier: GPL-3.0-or-later
// What each candidate does to the rows of some notes: they are checked once more with it, in memory.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "check/place/check_options.h"
#include "check/step/report.h"
#include "report/suggest/candidates.h"
#include "source/source_map.h"

namespace rigor {

/// At most so often are the notes checked again.
inline constexpr std::size_t most_candidates = 24;

/// A row whose verdict is another one with a directive; of what stands outside all rows, only what is new and
/// wrong.
struct RowChange {
  std::string place;   // `notes.md:12`, and its tag
  std::string source;  // of the row, or the message of what is wrong
  std::string before;  // `undecided`; empty: outside all rows
  std::string after;   // `proved`, `error`
};

struct Suggestion {
  std::vector<PlacedLine> lines = {};
  std::vector<std::string> why = {};    // the rows are open, in words
  std::vector<RowChange> settled = {};  // open rows that are decided, laws that are proved
  std::vector<RowChange> worse = {};    // rows that become refuted, suspect or wrong
  std::vector<RowChange> lost = {};     // rows that are open with it and were not
  bool accepted = false;
};

struct Suggestions {
  FileReport report;  // of the notes as they are
  std::size_t open = 0;
  std::vector<Suggestion> all = {};  // that do anything, in the order in which they were tried
  std::size_t tried = 0;
  bool some_left = false;  // candidates that were not tried
};

struct SuggestRequest {
  CheckOptions options = {};
  bool accepts_worse = false;  // also what makes rows refuted, suspect or wrong
};

/// Each candidate is tried together with those that were accepted before it. Accepted is what settles more
/// rows than it loses and makes none worse; of several alternatives the one that settles most. Cost: a check
/// of the notes for each candidate.
[[nodiscard]] Suggestions suggest_directives(SourceMap& sources, const std::string& path,
                                             const std::string& text, const SuggestRequest& request);

/// All lines that were accepted.
[[nodiscard]] std::vector<PlacedLine> accepted_lines(const Suggestions& suggestions);

}  // namespace rigor
