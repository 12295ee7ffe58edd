// SPDX-License-Identifier: GPL-3.0-or-later
// A refuted step of a report that was made earlier, whose sample is put in again instead of being searched
// for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "check/step/report.h"

namespace rigor {

struct RecordedStep {
  std::string file;          // as the report names it
  std::uint32_t line = 0;    // where the step begins
  std::uint32_t column = 0;  // the same
  std::string source;
  std::size_t earlier = 0;  // how many steps before it have the same place and text
  Counterexample example;

  // what putting it in finds
  std::optional<std::size_t> step = {};  // its position among the steps of the notes as they are now
  bool replayed = false;                 // the sample was put into the step's question…
  std::string fault = {};                // …and this speaks against it; empty: the sides differ there
};
using RecordedSteps = std::vector<RecordedStep>;

}  // namespace rigor
