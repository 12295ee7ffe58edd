// SPDX-License-Identifier: GPL-3.0-or-later
// The exact side: is a statement true for all values of its symbols?
#pragma once

#include "expr/statement.h"

namespace rigor {

struct Limits {
  std::uint32_t expanded_terms = 60'000;  // an estimate above it is `undecided`, with the figure
  std::uint64_t steps = 1'000'000;        // of evaluation, for the proofs and again for the samples
  std::uint32_t quick_points = 3;
  std::uint64_t quick_steps = 8'000;  // of evaluation, at samples, before a proof is tried
  std::uint32_t sample_attempts = 400;
  bool fewest_assumptions = true;  // what a proof does not need is left out of what it names
};

/// Proved: every component of left − right has the normal form zero at the generic point. Refuted: an exact
/// rational sample that satisfies the assumptions makes a component differ. Complete for polynomial and
/// rational identities in components, sums over any number of particles included; otherwise sound.
/// Deterministic. Never throws for any tree that `ExprTree::add` accepts.
[[nodiscard]] Decision decide(const Question& question, const Limits& limits = {});

/// Both sides of the claim on a sample, at the sample's axes: `{left, right}`, as exact numbers; empty if the
/// sample does not satisfy the assumptions, or a side has no rational value there.
struct SideValues {
  std::string left;
  std::string right;
};
[[nodiscard]] std::optional<SideValues> replay(const Question& question, const Sample& sample);

/// A sample (particles and values) that satisfies all assumptions; empty if none was found. What is known of
/// one, from fewer assumptions, is tried first, with new numbers for new symbols.
[[nodiscard]] std::optional<Sample> satisfying_sample(const Question& question, const Sample& known = {},
                                                      const Limits& limits = {});

/// Are the assumptions satisfied by any sample at all? Nothing found is `false`.
[[nodiscard]] inline bool satisfiable(const Question& question, const Limits& limits = {}) {
  return satisfying_sample(question, {}, limits).has_value();
}

}  // namespace rigor
