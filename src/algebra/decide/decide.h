// SPDX-License-Identifier: GPL-3.0-or-later
// The exact side: is a statement true for all values of its symbols?
#pragma once

#include "algebra/engine/limits.h"
#include "expr/statement/statement.h"

namespace rigor {

/// Proved: every component of left − right has the normal form zero at the generic point. Refuted: an exact
/// rational sample that satisfies the assumptions makes a component differ. Complete for polynomial and
/// rational identities in components, sums over any number of particles included; otherwise sound.
/// Deterministic. Never throws for any tree that `ExprTree::add` accepts.
[[nodiscard]] Decision decide(const Question& question, const Limits& limits = {});

/// Both sides of the claim on a sample, at the sample's axes, as exact numbers.
struct SideValues {
  std::string left;
  std::string right;
};

/// What a sample that others hold says of a question. Nothing is searched for.
struct Replay {
  enum class Fault : std::uint8_t {
    none,        // the assumptions hold, and both sides have a value
    place,       // the sample's axes or free particles do not fit the claim
    value,       // `symbol` has no value, or one that does not fit it
    assumption,  // the one at the position `assumption` does not hold, or has no value
    undefined,   // a side has no rational value
  };
  Fault fault = Fault::none;
  SymbolId symbol{};
  std::size_t assumption = 0;
  SideValues sides;
  bool differ = false;  // the sides are not related as the claim says
};
[[nodiscard]] Replay replay_closely(const Question& question, const Sample& sample);

/// The sides only; empty if there is any fault.
[[nodiscard]] std::optional<SideValues> replay(const Question& question, const Sample& sample);

/// What the defined symbols that stand in the claim are worth on a sample, as far as that is rational.
[[nodiscard]] std::vector<SampleValue> following_values(const Question& question, const Sample& sample);

/// The symbols that a sample of a question has values for, in the order of its values.
[[nodiscard]] std::vector<SymbolId> symbols_of_sample(const Question& question);

/// A sample (particles and values) that satisfies all assumptions; empty if none was found. What is known of
/// one, from fewer assumptions, is tried first, with new numbers for new symbols.
[[nodiscard]] std::optional<Sample> satisfying_sample(const Question& question, const Sample& known = {},
                                                      const Limits& limits = {});

/// Are the assumptions satisfied by any sample at all? Nothing found is `false`.
[[nodiscard]] inline bool satisfiable(const Question& question, const Limits& limits = {}) {
  return satisfying_sample(question, {}, limits).has_value();
}

}  // namespace rigor
