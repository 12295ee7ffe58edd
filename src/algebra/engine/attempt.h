// SPDX-License-Identifier: GPL-3.0-or-later
// One attempt at a proof, and what all attempts have cost.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "expr/tree/tree.h"

namespace rigor {

/// How hard to look for factors of a radicand (`radicals.h`).
enum class Effort : std::uint8_t { plain, factored };

/// A letter that is not 0.
struct KnownSign {
  SymbolId letter{};
  bool positive = true;
};

/// The conditions under which a proof is tried.
struct Attempt {
  Effort effort = Effort::plain;
  std::vector<std::size_t> assumptions = {};  // those to be used, by position
  std::vector<KnownSign> signs = {};          // the case of a distinction
};

/// What the attempts at one decision have cost together.
struct Work {
  double terms = 0;         // expanded, by the estimates
  std::uint64_t steps = 0;  // of evaluation
};

}  // namespace rigor
