// SPDX-License-Identifier: GPL-3.0-or-later
// What the head of a page or a document says of all its notes, in numbers and in words.
#pragma once

#include <string>
#include <string_view>

#include "check/step/report.h"

namespace rigor {

struct ShownTotals {
  Counts counts{};
  std::size_t steps = 0;
  std::size_t attention = 0;  // steps that need it
  std::size_t warned = 0;     // steps that have a warning
  std::size_t problems = 0;   // of files as a whole: what makes `rigor check` fail without a step
  std::size_t remarks = 0;    // warnings of files as a whole
};

/// Adds what a file has.
void add_to(ShownTotals& totals, const FileReport& report);

/// `3 steps: 1 needs attention, and there are 2 problems with the notes as a whole`, without a full stop;
/// what must be looked at is between `open` and `close`. Nothing is said to be well where the exit code
/// says otherwise.
[[nodiscard]] std::string attention_words(const ShownTotals& totals, std::string_view open = {},
                                          std::string_view close = {});

/// `1 definition`, `8 definitions`, `2 not understood`.
[[nodiscard]] std::string counted(Verdict verdict, std::size_t count);

}  // namespace rigor
