// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/verdict/decide_by_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "algebra/decide/decide.h"
#include "check/verdict/counterexample.h"

namespace rigor {
namespace {

/// What speaks against the sample; empty if nothing does.
std::string fault_of(const Prepared& prepared, const Replay& replay, const SideValues& recorded) {
  switch (replay.fault) {
    case Replay::Fault::none:
      break;
    case Replay::Fault::place:
      return "the sample's particles or component do not fit the step";
    case Replay::Fault::value:
      return fmt::format("the sample's value for `{}` is not one that this symbol can have",
                         prepared.question.tree->symbols[replay.symbol].name);
    case Replay::Fault::assumption: {
      const NamedAssumption* named = prepared.assumptions[replay.assumption];
      return named == nullptr ? "the sample does not satisfy what follows from a declaration"
                              : fmt::format("the sample does not satisfy {}", named->origin.text);
    }
    case Replay::Fault::undefined:
      return "a side has no rational value on the sample";
  }
  if (replay.sides.left != recorded.left || replay.sides.right != recorded.right)
    return fmt::format("the report says left {}, right {}, but its sample gives left {}, right {}",
                       recorded.left, recorded.right, replay.sides.left, replay.sides.right);
  return replay.differ ? "" : "the step holds on the sample";
}

/// The first of the recorded values that does not follow; empty if all do.
std::string fault_of_following(const Prepared& prepared, const Sample& sample,
                               const Counterexample& example) {
  if (example.follows.empty()) return "";
  const Counterexample now = describe(prepared, sample);
  for (const Counterexample::Value& value : example.follows) {
    const bool found = std::ranges::any_of(now.follows, [&](const auto& each) {
      return each.symbol == value.symbol && each.particle == value.particle && each.rank == value.rank &&
             each.components == value.components;
    });
    if (!found) return fmt::format("the value of `{}` does not follow from the sample", value.symbol);
  }
  return "";
}

}  // namespace

Decision decide_by_record(const Prepared& prepared, bool swapped, RecordedStep& recorded) {
  Decision decision;
  recorded.replayed = true;
  Result<Sample> sample = sample_of(prepared.question, recorded.example);
  if (!sample) {
    decision.reason = recorded.fault = sample.error().reason;
    return decision;
  }
  SideValues sides{recorded.example.left, recorded.example.right};
  if (swapped) std::swap(sides.left, sides.right);
  const Replay replay = replay_closely(prepared.question, *sample);
  recorded.fault = fault_of(prepared, replay, sides);
  if (recorded.fault.empty()) recorded.fault = fault_of_following(prepared, *sample, recorded.example);
  decision.reason = recorded.fault;
  if (!recorded.fault.empty()) return decision;
  sample->left = replay.sides.left;
  sample->right = replay.sides.right;
  decision.outcome = Outcome::refuted;
  decision.route = "recorded sample";
  decision.sample = *std::move(sample);
  return decision;
}

bool is_of_first_order(const Counterexample& example) {
  return std::ranges::any_of(example.values,
                             [](const auto& value) { return value.symbol.starts_with("\\delta "); });
}

}  // namespace rigor
