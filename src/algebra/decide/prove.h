// SPDX-License-Identifier: GPL-3.0-or-later
// The proof of a claim at the generic point: every component of left − right has the normal form zero, or,
// for a claim with <, ≤ or ≠, a sign that allows it.
#pragma once

#include <vector>

#include "algebra/engine/attempt.h"
#include "algebra/engine/limits.h"
#include "algebra/point/scope.h"

namespace rigor {

struct Proof {
  bool holds = false;     // every component of left − right vanishes, or has the right sign
  bool vanishes = false;  // and every component of the left side alone
  bool moments = false;   // what it took
  bool unit_vectors = false;
  bool rotations = false;
  bool radicals = false;
  bool functions = false;
  bool order = false;                  // by signs
  bool unsolved_assumptions = false;   // does not hold, and an assumption could not be solved for
  std::vector<std::size_t> used = {};  // holds: positions of assumptions that are likely to be enough
};

/// Throws Undecidable (also for exceptions of the computer algebra library).
[[nodiscard]] Proof prove(const Scope& scope, const Attempt& attempt, const Limits& limits, Work& work);

}  // namespace rigor
