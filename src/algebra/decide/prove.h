// SPDX-License-Identifier: GPL-3.0-or-later
// The proof of a claim at the generic point: every component of left − right has the normal form zero, or,
// for a claim with <, ≤ or ≠, a sign that allows it.
#pragma once

#include <vector>

#include "algebra/engine/attempt.h"
#include "algebra/engine/limits.h"
#include "algebra/point/scope.h"
#include "expr/statement/proof.h"

namespace rigor {

/// The result of one attempt.
struct Trial {
  bool holds = false;
  bool radicals = false;               // roots occurred
  bool unsolved_assumptions = false;   // does not hold, and an assumption could not be solved for
  std::vector<std::size_t> used = {};  // holds: positions of assumptions that are likely to be enough
  Proof proof = {};                    // holds; its `unfolded` is left to the caller
};

/// Throws Undecidable (also for exceptions of the computer algebra library).
[[nodiscard]] Trial prove(const Scope& scope, const Attempt& attempt, const Limits& limits, Work& work);

}  // namespace rigor
