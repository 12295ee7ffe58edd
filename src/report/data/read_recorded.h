// SPDX-License-Identifier: GPL-3.0-or-later
// The refuted steps of a report that was printed as JSON.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "check/step/recorded.h"

namespace rigor {

/// One of the notes that the report is about.
struct RecordedFile {
  std::string path;     // as in the report
  std::string sidecar;  // the same; empty: none was read
  RecordedSteps steps;  // the refuted ones, in the report's order
};

/// Reads what `to_json` writes; keys that are not needed are not looked at. An error names the place in the
/// JSON: `files[0].steps[2].counterexample.left is not a string`. Never throws, whatever the text is.
[[nodiscard]] Result<std::vector<RecordedFile>> read_recorded(std::string_view json);

}  // namespace rigor
