// SPDX-License-Identifier: GPL-3.0-or-later
// How much work a decision may take. Work is counted, never timed: the answer is the same on every machine.
#pragma once

#include <cstdint>

#include "algebra/engine/budget.h"

namespace rigor {

struct Limits {
  std::uint32_t expanded_terms = 60'000;  // an estimate above it is `undecided`, with the figure
  std::uint64_t steps = 1'000'000;        // of evaluation, for the proofs and again for the samples
  std::uint32_t quick_points = 3;
  std::uint64_t quick_steps = 8'000;  // of evaluation, at samples, before a proof is tried
  std::uint32_t sample_attempts = 400;
  bool fewest_assumptions = true;  // assumptions that a proof does not need are dropped from it
  bool simplest_sample = true;     // a refutation's sample gets small numbers, fit for a blackboard
  bool only_proofs = false;        // nobody asks what refutes: after the proofs no sample is searched for
  bool sign_cases = true;          // a root of what is negative has no value; not so beside complex numbers
  Budget* budget = nullptr;        // shared by all questions about a step; none: each has its own
};

}  // namespace rigor
