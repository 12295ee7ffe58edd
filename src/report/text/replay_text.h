// SPDX-License-Identifier: GPL-3.0-or-later
// What became of a report's refutations when their samples were put in again, as text:
//
//   notes/vectors.tex:12:3: confirmed: left -1, right 1
//   notes/vectors.tex:20:3: error: not confirmed: the notes have no such step at 20:3 [not-confirmed]
#pragma once

#include <string>

#include "check/step/recorded.h"
#include "report/text/terminal.h"

namespace rigor {

/// The step was found in the notes, its sample meets the assumptions, and its sides differ as recorded.
[[nodiscard]] bool is_confirmed(const RecordedStep& recorded, const FileReport& notes);

/// One refutation; ends with a line break. `notes` is the check into which `recorded` was put.
[[nodiscard]] std::string print_replay(const RecordedStep& recorded, const FileReport& notes,
                                       const SourceMap& sources, const TerminalOptions& options = {});

struct ReplayTally {
  std::size_t confirmed = 0;
  std::size_t not_confirmed = 0;
  bool unreadable = false;  // some notes
  bool malformed = false;   // the report
};
/// `3 refutations: 2 confirmed, 1 not confirmed`
[[nodiscard]] std::string print_tally(const ReplayTally& tally);

}  // namespace rigor
