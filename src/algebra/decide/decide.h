// SPDX-License-Identifier: GPL-3.0-or-later
// The exact side: is a statement true for all values of its symbols?
//
// A proof takes every symbol at its generic point, where its components are indeterminates. There each
// component of left − right is a fraction, and its numerator is a polynomial. A polynomial that is 0 for all
// values is the polynomial 0, so expanding decides the question without rewriting rules, and one proof covers
// every number of particles (`ring/moments.h`). Assumptions are solved first (`generic/constraints.h`).
// A proof that fails refutes nothing: an assumption may not have been solved, or roots and functions may be
// related in ways that are not known here. So a refutation is an exact sample, which is put into the question
// again before it is returned. A few samples come first, since they refute most false claims within
// microseconds.
#pragma once

#include "algebra/engine/limits.h"
#include "expr/statement/statement.h"

namespace rigor {

/// Proved: every component of left − right has the normal form zero at the generic point. Refuted: an exact
/// rational sample that satisfies the assumptions makes a component differ. Undecided: neither was found,
/// with the reason. Complete for polynomial and rational identities in components, sums over any number of
/// particles included; otherwise sound. Deterministic, since `limits` count work and no time. Never throws
/// for any tree that `ExprTree::add` accepts.
[[nodiscard]] Decision decide(const Question& question, const Limits& limits = {});

/// Both sides of the claim on a sample, at the sample's axes, as exact numbers.
struct SideValues {
  std::string left;
  std::string right;
};

/// What a given sample says about a question: it is put in, and nothing is searched for.
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

/// The values of the claim's defined symbols on a sample, where they are rational.
[[nodiscard]] std::vector<SampleValue> following_values(const Question& question, const Sample& sample);

/// The symbols that a sample of a question has values for, in the order of its values.
[[nodiscard]] std::vector<SymbolId> symbols_of_sample(const Question& question);

/// A sample (particles and values) that satisfies all assumptions; empty if none was found. `known`, a sample
/// of fewer assumptions, is tried first, with new numbers for new symbols.
[[nodiscard]] std::optional<Sample> satisfying_sample(const Question& question, const Sample& known = {},
                                                      const Limits& limits = {});

}  // namespace rigor
