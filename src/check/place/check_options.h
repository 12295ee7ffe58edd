// SPDX-License-Identifier: GPL-3.0-or-later
// What a check is asked for, and what it may use.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "algebra/engine/budget.h"
#include "check/step/recorded.h"

namespace rigor {

class DecisionCache;

/// For which steps the nearest true statements and missing conditions are looked for: for those that are
/// wrong or undecided, also for those that are expected to be wrong, and for laws as well.
enum class Repairs : std::uint8_t { none, of_unexpected, of_all, and_of_laws };

struct CheckOptions {
  std::optional<std::string> sidecar = {};  // without it, `NAME.rigor` next to the notes, if there is one
  std::string directives = {};              // read as if they stood at the end of the sidecar
  std::function<void(std::size_t done, std::size_t all)> progress = {};  // called after each display
  Repairs repairs = Repairs::of_unexpected;
  std::optional<std::uint32_t> near_at = {};  // what is near open rows: of the chain that stands there only
  RecordedSteps* recorded = nullptr;  // refuted steps of an earlier report: their samples are put in again
  DecisionCache* cache = nullptr;     // answers of earlier runs; null: one that only counts the work is made
  std::uint64_t effort = default_effort;  // for each step, and again for what helps where it is wrong
  std::size_t processes = 1;  // at once, for what is offered beside wrong steps; the answer is the same
};

}  // namespace rigor
