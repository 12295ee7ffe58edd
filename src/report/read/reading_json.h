// SPDX-License-Identifier: GPL-3.0-or-later
// How the rows of some notes were read, as JSON (`docs/json.md`).
#pragma once

#include <string>

#include "check/shown/read_row.h"
#include "source/source_map.h"

namespace rigor {

/// Ends with a line break. The same notes give the same bytes.
[[nodiscard]] std::string reading_json(const NotesReading& reading, const SourceMap& sources);

}  // namespace rigor
