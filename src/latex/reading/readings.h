// SPDX-License-Identifier: GPL-3.0-or-later
// The sides of a chain, in every way in which they can be read.
#pragma once

#include <vector>

#include "latex/split/split.h"
#include "latex/token/choices.h"
#include "latex/token/syntax.h"

namespace rigor {

struct Readings {
  std::vector<SyntaxId> sides;  // with the first reading at each place
  std::vector<Choice> choices;  // the places
  /// The other readings; the first of them takes the second way at each place. All of them, unless there are
  /// more than two places: then that one alone.
  std::vector<std::vector<SyntaxId>> others;
};

/// Cost: that of `parse_side`, four times at most.
[[nodiscard]] Readings parse_readings(const WrittenChain& chain, SyntaxTree& syntax);

}  // namespace rigor
