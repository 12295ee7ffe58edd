// SPDX-License-Identifier: GPL-3.0-or-later
// How the rows of some notes were read, for people:
//
//   notes.md:17:4 (3)
//     written   L_i L_i = L^2
//     read as   \sum_i L_i L_i = L^2
//     role      identity: to be proved for all values of its letters
//     letters   \mathbf{L}  vector  written `\mathbf{L}` in line 13
//               i           index, summed since it stands twice in a term
#pragma once

#include <string>

#include "check/shown/read_row.h"
#include "report/text/terminal.h"
#include "source/source_map.h"

namespace rigor {

/// The rows that are in `reading`, and a line that counts them.
[[nodiscard]] std::string reading_text(const NotesReading& reading, const SourceMap& sources,
                                       const TerminalOptions& options);

}  // namespace rigor
