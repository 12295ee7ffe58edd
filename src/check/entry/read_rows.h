// SPDX-License-Identifier: GPL-3.0-or-later
// From a file of notes to how each row was read.
#pragma once

#include <string>

#include "check/place/check_options.h"
#include "check/shown/read_row.h"
#include "source/source_map.h"

namespace rigor {

/// Decides only whether a name gets a second meaning, and whether a row reads as an identity. Never throws
/// for anything in the notes.
[[nodiscard]] NotesReading read_rows(SourceMap& sources, const std::string& path, CheckOptions options = {});
/// The same for text in memory.
[[nodiscard]] NotesReading read_rows_of_text(SourceMap& sources, const std::string& path, std::string text,
                                             CheckOptions options = {});

}  // namespace rigor
