// SPDX-License-Identifier: GPL-3.0-or-later
// From a file of notes to verdicts.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "algebra/engine/budget.h"
#include "check/step/recorded.h"
#include "source/source_map.h"

namespace rigor {

class DecisionCache;
class FormRecorder;

/// Of which wrong steps the nearest true statements and missing conditions are looked for.
enum class Repairs : std::uint8_t { none, of_unexpected, of_all };

struct CheckOptions {
  std::optional<std::string> sidecar = {};  // without it, `NAME.rigor` beside the notes, if there is one
  std::function<void(std::size_t done, std::size_t all)> progress = {};  // called after each display
  Repairs repairs = Repairs::of_unexpected;
  FormRecorder* forms = nullptr;      // collects for the floating-point side, and says what is needed
  RecordedSteps* recorded = nullptr;  // refuted steps of an earlier report: their samples are put in again
  DecisionCache* cache = nullptr;     // decisions of earlier runs; none: they are only counted
  std::uint64_t effort = default_effort;  // for each step, and again for what helps where it is wrong
};

/// Never throws for anything that is in the notes. A file that cannot be read is reported as such.
[[nodiscard]] FileReport check_file(SourceMap& sources, const std::string& path,
                                    const CheckOptions& options = {});

/// The same for text in memory (`path` decides the format and is what diagnostics show).
[[nodiscard]] FileReport check_text(SourceMap& sources, const std::string& path, std::string text,
                                    const CheckOptions& options = {});

}  // namespace rigor
