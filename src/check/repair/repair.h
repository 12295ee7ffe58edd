// SPDX-License-Identifier: GPL-3.0-or-later
// What a wrong step may have been meant to say: the statements nearest to it that can be proved.
#pragma once

#include <vector>

#include "algebra/engine/limits.h"
#include "check/repair/repair_candidates.h"
#include "check/step/report.h"
#include "elaborate/name/names.h"
#include "expr/tree/tree.h"

namespace rigor {

class DecisionCache;

inline constexpr std::size_t most_repairs = 3;

/// For a guess at what was meant beside the step.
inline constexpr Limits limits_of_guesses{.expanded_terms = 3'000,
                                          .steps = 20'000,
                                          .quick_points = 2,
                                          .quick_steps = 4'000,
                                          .sample_attempts = 12,
                                          .fewest_assumptions = false};

/// At most three, the nearest first; none where no slip of the pen makes it true. Of a refuted step, or of
/// one whose indices or ranks do not fit. Method: each side is rewritten; terms are compared by the number
/// that the difference of the sides is of each (`left − right = c · term`); what holds on exact samples is
/// read anew with its whole chain, and proved. Trivial statements (a = a, 0 = 0, v − v = 0) are left out. It
/// works on copies. Cost: a few milliseconds for a typical step (tests/bench/repair_bench.cpp); sides of more
/// than 400 tokens are not mended.
[[nodiscard]] std::vector<Repair> nearest_true_statements(const ExprTree& tree, const Names& names,
                                                          const WrongStep& wrong,
                                                          DecisionCache* cache = nullptr);

}  // namespace rigor
