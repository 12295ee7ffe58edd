// SPDX-License-Identifier: GPL-3.0-or-later
// Claims about sums up to a letter, which are meant for whole numbers only.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>

#include "check/step/recorded.h"
#include "check/verdict/counted_letter.h"
#include "check/verdict/judge.h"

namespace rigor {
namespace {

/// Takes the value of the letter out of a list, where it is one of a plain number.
std::optional<Counterexample::Value> taken(std::vector<Counterexample::Value>& values,
                                           const std::string& name) {
  const auto found = std::ranges::find_if(values, [&](const Counterexample::Value& each) {
    return each.symbol == name && each.rank == 0 && each.particle == 0 && each.components.size() == 1;
  });
  if (found == values.end()) return std::nullopt;
  Counterexample::Value value = *found;
  values.erase(found);
  return value;
}

/// A claim about sums up to a letter: refuted at a whole number, proved as it stands or by induction.
class JudgingCounted {
 public:
  JudgingCounted(ExprTree& tree, const Names& names, const Claim& claim, const Limits& limits,
                 DecisionCache* cache)
      : tree_(tree), names_(names), claim_(claim), limits_(limits), cache_(cache) {}

  Judgement judge() {
    const auto counted = counted_letter(tree_, names_, claim_.equation);
    if (claim_.recorded != nullptr && counted) return by_record(counted->letter);
    Judgement whole = judge_in(names_, claim_);
    if (whole.verdict == Verdict::proved || claim_.nearly) return whole;
    bool holds = true;
    std::optional<Judgement> failing;
    int failures = 0;
    for (int k = 0; counted && k < numbers_tried; ++k) {
      Judgement at = judge_at(counted->letter, counted->first + k);
      holds = holds && at.verdict == Verdict::proved;
      failures += at.verdict == Verdict::refuted ? 1 : 0;
      if (at.verdict == Verdict::refuted && !failing) failing = std::move(at);
    }
    if (failures > 1) return *std::move(failing);
    // `\sum_{k=0}^{n-1}\cos\frac{2\pi k}{n} = 0` fails at n = 1 alone, which need not be meant.
    if (failing)
      return open(std::move(whole),
                  fmt::format("it was found to fail at `{}` = {} only", tree_.symbols[counted->letter].name,
                              failing->counterexample->values.front().components.front()));
    if (counted && holds && counted->by_induction && steps_on(*counted)) {
      whole.verdict = Verdict::proved;
      whole.route =
          fmt::format("induction over `{}` from {}", tree_.symbols[counted->letter].name, counted->first);
      whole.of_another_question = true;
      whole.counterexample.reset();
      whole.sample.reset();
      whole.not_for_all.clear();
      whole.diagnostics.clear();
      return whole;
    }
    if (whole.verdict != Verdict::refuted) return whole;
    return open(std::move(whole), "it was found to fail only where a limit of a sum is no whole number");
  }

 private:
  static constexpr int numbers_tried = 4;

  Judgement judge_in(const Names& names, const Claim& claim) {
    return judge_at_once(tree_, names, claim, limits_, cache_);
  }
  [[nodiscard]] Judgement open(Judgement judgement, std::string why) const {
    judgement.verdict = Verdict::undecided;
    judgement.counterexample.reset();
    judgement.sample.reset();
    judgement.not_for_all.clear();
    judgement.diagnostics = {{DiagnosticKind::undecided, claim_.relation, std::move(why), {}, {}}};
    return judgement;
  }

  /// The number is one of the sample's.
  Judgement judge_at(SymbolId letter, int number) {
    Judgement at = judge_in(at_number(tree_, names_, letter, number), claim_);
    if (!at.counterexample) return at;
    const std::string& name = tree_.symbols[letter].name;
    static_cast<void>(taken(at.counterexample->follows, name));
    at.counterexample->values.insert(at.counterexample->values.begin(),
                                     {.symbol = name, .components = {std::to_string(number)}});
    return at;
  }

  Judgement by_record(SymbolId letter) {
    RecordedStep bare = *claim_.recorded;
    const auto value = taken(bare.example.values, tree_.symbols[letter].name);
    if (!value) return judge_in(names_, claim_);
    Claim claim = claim_;
    claim.recorded = &bare;
    Judgement at = judge_in(at_number(tree_, names_, letter, std::atoi(value->components[0].c_str())), claim);
    claim_.recorded->replayed = bare.replayed;
    claim_.recorded->fault = bare.fault;
    return at;
  }

  /// Does the claim follow at n + 1 from what it says at n? It holds at the first number.
  bool steps_on(const CountedLetter& counted) {
    const auto next = advanced(tree_, claim_.equation, counted.letter);
    if (!next || claim_.equation.relation != Relation::equal) return false;
    Names below = names_;
    assume(below.scope,
           {.equation = claim_.equation, .origin = Origin{"the claim at the number before", ""}});
    Claim claim = claim_;
    claim.equation = *next;
    return judge_in(below, claim).verdict == Verdict::proved;
  }

  ExprTree& tree_;
  const Names& names_;
  const Claim& claim_;
  Limits limits_;
  DecisionCache* cache_;
};

}  // namespace

Judgement judge_counted(ExprTree& tree, const Names& names, const Claim& claim, const Limits& limits,
                        DecisionCache* cache) {
  return JudgingCounted(tree, names, claim, limits, cache).judge();
}

}  // namespace rigor
