// SPDX-License-Identifier: GPL-3.0-or-later
// A report as one JSON object; `docs/json.md` describes it.
#pragma once

#include <string>

#include "check/step/report.h"
#include "source/source_map.h"

namespace rigor {

/// Ends with a line break. Keys are in a fixed order; only `milliseconds` differs between two runs on the
/// same notes. Bytes that are not UTF-8 (in a path, say) become U+FFFD.
[[nodiscard]] std::string to_json(const Report& report, const SourceMap& sources);

}  // namespace rigor
