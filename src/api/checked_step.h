// SPDX-License-Identifier: GPL-3.0-or-later
// From a report to the values that the library hands out.
#pragma once

#include <rigor/rigor.h>

#include "check/step/report.h"
#include "source/source_map.h"

namespace rigor {

/// One step of a report; `holds` by itself, whatever is wrong elsewhere in the file.
[[nodiscard]] CheckedStep checked_step(const FileReport& file, const Step& step, const SourceMap& sources,
                                       bool strict);

/// The diagnostics of no step, as text; `wrong` if it has an error.
struct RestOfNotes {
  bool wrong = false;
  std::string message;
};
[[nodiscard]] RestOfNotes rest_of_notes(const FileReport& file, const SourceMap& sources, bool strict);

}  // namespace rigor
