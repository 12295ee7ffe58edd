// SPDX-License-Identifier: GPL-3.0-or-later
// The proof of a claim at the generic point: every component of left − right has the normal form zero.
#pragma once

#include <span>

#include "algebra/decide.h"
#include "algebra/scope.h"

namespace rigor {

/// How hard to look for factors of what stands under a root (`radicals.h`).
enum class Effort : std::uint8_t { plain, factored };

struct Proof {
  bool holds = false;     // every component of left − right vanishes
  bool vanishes = false;  // and every component of the left side alone
  bool moments = false;   // what it took
  bool unit_vectors = false;
  bool radicals = false;
  bool unsolved_assumptions = false;  // does not hold, and an assumption could not be solved for
};

/// Throws Undecidable (also for exceptions of the computer algebra library).
[[nodiscard]] Proof prove(const Scope& scope, std::span<const std::size_t> assumptions, const Limits& limits,
                          Effort effort = Effort::plain);

}  // namespace rigor
