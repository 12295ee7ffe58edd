// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/row/row.h"

#include <fmt/format.h>

#include <utility>

#include "check/doubt/row_doubts.h"

namespace rigor {
namespace {

/// `\frac12 m\dot r^2` where the velocity is meant: if the letter is wrong and the vector is right, it is
/// read so.
bool proves_with_dots_on_vectors(RowPlace& place, const StepReading& row, const Claim& claim, Step& step) {
  if (!claim.reading->found.dotted_length) return false;
  ChainReading reading(place.notes.syntax, place.tree, place.names, row.parsed,
                       {.no_sum = row.parsed.written.no_sum, .dots_on_vectors = true});
  add_used(place, reading.used());
  if (!reading.sides[row.which].typed || !reading.sides[row.which + 1].typed) return false;
  Diagnostics mismatches;
  const auto other = reading.claim(row.parsed, row.which, false, mismatches);
  if (!other) return false;
  Judgement judgement = judge_here(place, *other);
  if (judgement.verdict != Verdict::proved) return false;
  judgement.diagnostics.push_back(
      {DiagnosticKind::dotted_length,
       *claim.reading->found.dotted_length,
       fmt::format("`{}` is the rate of a length; read as the length of the vector's rate",
                   written_at(place, *claim.reading->found.dotted_length)),
       {},
       {"set the letter bold, or put an arrow on it"}});
  accept(std::move(judgement), step);
  return true;
}

/// Keeps what the exact side was asked, if that is wanted; it is taken from the judgement.
void keep_asked(const StepReading& row, Judgement& judgement) {
  if (row.asked == nullptr) return;
  WrittenStep& asked = *row.asked;
  if (!judgement.of_another_question) {
    asked.question = std::move(judgement.question);
    asked.question->tree = nullptr;
  }
  asked.sample = std::move(judgement.sample);
  asked.names = std::move(judgement.names);
  asked.nearly_question = std::move(judgement.nearly_question);
  if (asked.nearly_question) asked.nearly_question->exact.tree = nullptr;
}

/// `for $x > 0$`, "the mass $m$": what is said of the numbers of a row, whether its proof needs it or not.
void keep_conditions(RowPlace& place, const StepReading& row, const Claim& claim) {
  if (row.asked == nullptr || row.role != Role::display) return;
  for (const Fact& fact : standpoint(place, row.parsed).facts) {
    if (fact.proves && fact.equation.relation != Relation::equal)
      row.asked->conditions.push_back(fact.equation);
  }
  for (const NamedAssumption& size : sizes_said(place, claim)) row.asked->conditions.push_back(size.equation);
}

/// Refuted where an index is free on one side and was read as not summed on the other.
void doubt_index(const RowPlace& place, const StepReading& row, Step& step) {
  const std::string& index = *row.reading.how().unsummed.begin();
  const bool labels = can_be_labels(place.notes.syntax, row.parsed, row.which);
  step.diagnostics = {
      {labels ? DiagnosticKind::ambiguous_reading : DiagnosticKind::free_index_mismatch, row.relation().span,
       labels ? fmt::format("`{}` can be a label of both sides, or a free index of one side only", index)
              : fmt::format("index `{}` is free on one side and summed on the other", index)}};
  if (labels) step.verdict = Verdict::not_understood;
}

}  // namespace

std::optional<Judgement> ask(RowPlace& place, const StepReading& row, const Claim& claim, Step& step) {
  if (claim.recorded != nullptr && replay_by_digits(place, claim, step)) return std::nullopt;
  if (row.unsettled) {
    decide_in_all_readings(place, row, claim, step);
    return std::nullopt;
  }
  Judgement judgement = judge_here(place, claim);
  if (row.role == Role::display && judgement.verdict != Verdict::proved &&
      is_condition_beside(place, row.parsed)) {
    keep_asked(row, judgement);
    step.verdict = Verdict::given;
    step.route = "condition of the equation next to it";
    return std::nullopt;
  }
  if (is_open(judgement) && proves_with_dots_on_vectors(place, row, claim, step)) return std::nullopt;
  const bool may_be_alternative = row.role == Role::display && claim.recorded == nullptr;
  if (is_open(judgement) && may_be_alternative && proves_alternatives(place, row.parsed, step))
    return std::nullopt;
  return judgement;
}

void settle(RowPlace& place, const StepReading& row, const Claim& claim, Judgement judgement, Step& step) {
  heed_surroundings(place, row, claim, judgement);
  keep_asked(row, judgement);
  keep_conditions(place, row, claim);
  if (judgement.verdict == Verdict::refuted && !row.reading.how().unsummed.empty())
    return doubt_index(place, row, step);
  const Op op = place.tree[row.left().typed->id].op;
  const bool symbol_by_cases =
      (op == Op::delta || op == Op::epsilon) && place.tree[row.right().typed->id].op == Op::table;
  if (symbol_by_cases && judgement.verdict == Verdict::proved) {
    judgement.verdict = Verdict::definition;
    judgement.route += ", agrees with the built-in symbol";
  }
  const bool both_ways = row.parsed.written.inference == Inference::equivalence;
  if (both_ways && judgement.verdict == Verdict::proved && !judgement.uses.empty()) {
    judgement.verdict = Verdict::undecided;
    judgement.diagnostics.push_back(
        {DiagnosticKind::undecided,
         claim.relation,
         "it follows from what stands before it; the other direction is not asked for yet",
         {},
         {"`\\Rightarrow` claims this direction only"}});
  }
  if (is_open(judgement)) offer_what_is_near(place, row, claim, judgement);
  accept(std::move(judgement), step);
}

void accept(Judgement judgement, Step& step) {
  step.verdict = judgement.verdict;
  step.restates = judgement.restates;
  step.measures = judgement.measures;
  step.route = std::move(judgement.route);
  step.uses = std::move(judgement.uses);
  step.repairs = std::move(judgement.repairs);
  step.counterexample = std::move(judgement.counterexample);
  step.diagnostics.insert(step.diagnostics.end(), judgement.diagnostics.begin(), judgement.diagnostics.end());
}

}  // namespace rigor
