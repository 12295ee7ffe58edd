// SPDX-License-Identifier: GPL-3.0-or-later
// One step of a chain: what its relation asks, and the verdict.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "check/doubt/digits.h"
#include "check/doubt/row_doubts.h"
#include "check/question/decision_cache.h"
#include "check/question/unread.h"
#include "check/walk/readings.h"
#include "check/walk/session.h"
#include "expr/calculus/differentiate.h"

namespace rigor {
namespace {

using Clock = std::chrono::steady_clock;

/// Why a relation is not decided, if so.
std::optional<Diagnostic> why_not_decided(const WrittenRelation& relation) {
  switch (relation.kind) {
    case RelationKind::other:
    case RelationKind::implies:
      return Diagnostic{DiagnosticKind::unsupported, relation.span,
                        fmt::format("the relation `{}` is not decided yet", relation.text)};
    case RelationKind::much_less:
    case RelationKind::much_greater:
      return Diagnostic{DiagnosticKind::unsupported,
                        relation.span,
                        fmt::format("`{}` is no claim that can be decided", relation.text),
                        {},
                        {"`rigor: small …` says what is small"}};
    case RelationKind::demanded:
      return Diagnostic{DiagnosticKind::unsupported,
                        relation.span,
                        "an equation that is demanded is not a claim",
                        {},
                        {"`rigor: given` makes it an assumption"}};
    default:
      return std::nullopt;
  }
}

/// Is nothing in the way but what is asked for?
bool only_asks(const Diagnostics& diagnostics) {
  bool asks = false;
  for (const Diagnostic& diagnostic : diagnostics) {
    const Severity severity = diagnostic.severity();
    if (diagnostic.kind != DiagnosticKind::hole && severity != Severity::warning) return false;
    asks = asks || diagnostic.kind == DiagnosticKind::hole;
  }
  return asks;
}

}  // namespace

void Session::step(const ParsedChain& parsed, std::size_t which, ChainReading& reading,
                   const Context& context) {
  const auto start = Clock::now();
  options_.cache->begin(options_.effort);
  Step step = new_step(parsed, which, context);
  const WrittenRelation& relation = parsed.written.relations[which];
  const std::vector<Side>& sides = reading.sides;
  const bool up_to_order = decides_up_to_order(parsed, which, context, step);
  for (const std::size_t side : {which, which + 1}) {
    if (up_to_order) break;
    const bool first_mention = which == 0 || side == which + 1;
    const bool blocked_by_it_alone =
        !sides[side].typed && sides[which].typed.has_value() != sides[which + 1].typed.has_value();
    if (!first_mention && !blocked_by_it_alone) continue;
    step.diagnostics.insert(step.diagnostics.end(), sides[side].diagnostics.begin(),
                            sides[side].diagnostics.end());
  }
  const bool readable = sides[which].typed && sides[which + 1].typed;
  if (up_to_order) {
    // the sides are not read as wholes
  } else if (parsed.written.condition) {
    const Obstacle& condition = *parsed.written.condition;
    step.diagnostics.push_back(
        {condition.kind, parsed.written.condition_span, condition.message, {}, condition.help});
  } else if (const auto reason = why_not_decided(relation)) {
    step.diagnostics.push_back(*reason);
    if (context.role == Role::display)
      unread_rows_.emplace_back(notes_.prose.beside[event_].place, step.span);
  } else if (readable) {
    decide_step(parsed, which, reading, context, step);
  }
  doubt_errors(notes_.syntax, names_, parsed, which, step.diagnostics);
  if (only_asks(step.diagnostics)) step.verdict = Verdict::undecided;
  const bool assumes = context.role == Role::given || context.role == Role::let;
  if (assumes && step.verdict == Verdict::not_understood) {
    std::string text = step.source;
    std::set<std::string> letters = letters_of(text);
    names_.note_unread({std::move(text), std::move(letters), context.directive});
  }
  if (readable && parsed.image == 0) {
    const bool directed = context.role == Role::let || context.role == Role::given;
    const bool passing = is_for_now(context);
    stated_.push_back({sides[which].typed->id, sides[which + 1].typed->id, relation.span, relation.kind,
                       !directed, passing, report_.steps.size()});
  }
  step.milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  step.work = options_.cache->budget().used();
  add(std::move(step));
}

/// `\frac12 m\dot r^2` where the velocity is meant: if the letter is wrong and the vector is right, it is
/// read so.
bool Session::proves_with_dots_on_vectors(const ParsedChain& parsed, std::size_t which, const Claim& claim,
                                          Step& step) {
  if (!claim.reading->has_dotted_length()) return false;
  ChainReading reading(notes_.syntax, tree_, names_, parsed,
                       {.no_sum = parsed.written.no_sum, .dots_on_vectors = true});
  if (!reading.sides[which].typed || !reading.sides[which + 1].typed) return false;
  Diagnostics mismatches;
  const auto other = reading.claim(parsed, which, false, mismatches);
  if (!other) return false;
  Judgement judgement = judge(tree_, names_, *other, {}, options_.cache);
  if (judgement.verdict != Verdict::proved) return false;
  judgement.diagnostics.push_back(
      {DiagnosticKind::dotted_length,
       claim.reading->dotted_length(),
       fmt::format("`{}` is the rate of a length; read as the length of the vector's rate",
                   written(claim.reading->dotted_length())),
       {},
       {"set the letter bold, or put an arrow on it"}});
  accept(std::move(judgement), step);
  return true;
}

/// The earlier report's step at the same place with the same text, which several steps can have if directives
/// are anchored there. It learns which step it is.
RecordedStep* Session::recorded_of(const Step& step) {
  if (options_.recorded == nullptr) return nullptr;
  const LineColumn place = sources_.line_column(step.span.file, step.span.begin);
  const auto is_alike = [&](const Step& other) {
    return other.span.file == step.span.file && other.span.begin == step.span.begin &&
           other.source == step.source;
  };
  const auto earlier =
      static_cast<std::size_t>(std::count_if(report_.steps.begin(), report_.steps.end(), is_alike));
  for (RecordedStep& each : *options_.recorded) {
    if (each.earlier != earlier || each.line != place.line || each.column != place.column) continue;
    if (each.source != step.source || each.file != sources_.path(step.span.file)) continue;
    each.step = report_.steps.size();
    return &each;
  }
  return nullptr;
}

void Session::accept(Judgement judgement, Step& step) {
  step.verdict = judgement.verdict;
  step.route = std::move(judgement.route);
  step.uses = std::move(judgement.uses);
  step.counterexample = std::move(judgement.counterexample);
  step.diagnostics.insert(step.diagnostics.end(), judgement.diagnostics.begin(), judgement.diagnostics.end());
}

void Session::decide_step(const ParsedChain& parsed, std::size_t which, ChainReading& reading,
                          const Context& context, Step& step) {
  const Side& left = reading.sides[which];
  const Side& right = reading.sides[which + 1];
  const WrittenRelation& relation = parsed.written.relations[which];
  const bool unsettled = std::any_of(parsed.choices.begin(), parsed.choices.end(), [&](const Choice& choice) {
    return choice.span.begin >= step.span.begin && choice.span.end <= step.span.end;
  });
  const bool may_define = which == 0 && !is_order(relation.kind) && relation.kind != RelationKind::nearly &&
                          !is_alternative(parsed) &&
                          !shows_circle_number(tree_, names_, *left.typed, *right.typed);
  const bool claims = context.role == Role::display || context.role == Role::claim;
  if (unsettled && (!claims || (may_define && would_define(*left.typed, *right.typed)))) {
    step.diagnostics.push_back(two_readings(parsed));
    return;
  }
  if (!unsettled && may_define && defines(parsed, left, right, context, step)) return;
  const bool bare_square =
      tree_[left.typed->id].op == Op::power && !stands_in_brackets(parsed.sides[0]);  // a law, also anew
  const bool may_replace = may_define && !bare_square && may_redefine(*left.typed, *right.typed);
  Diagnostics mismatches;
  auto claim = reading.claim(parsed, which, context.first_order, mismatches);
  step.diagnostics.insert(step.diagnostics.end(), mismatches.begin(), mismatches.end());
  if (!claim) return;
  claim->recorded = recorded_of(step);
  if (context.role == Role::given) {
    add_assumption(*left.typed, *right.typed, claim->equation, parsed, which, context, step);
    return;
  }
  if (context.role == Role::let) {
    step.diagnostics.push_back({DiagnosticKind::bad_directive,
                                step.relation_span,
                                "`let` defines one symbol, alone on the left side and not on the right",
                                {},
                                {"`rigor: given` assumes an equation"}});
    return;
  }
  if (!decides() && !may_replace) return;
  if (claim->recorded != nullptr && replay_by_digits(*claim, step)) return;
  if (unsettled) {
    decide_in_all_readings(parsed, which, *claim, step);
    return;
  }
  claim->explains = options_.forms != nullptr;
  Judgement judgement = judge(tree_, names_, *claim, {}, options_.cache);
  if (context.role == Role::display && judgement.verdict != Verdict::proved && is_condition_beside(parsed)) {
    if (options_.forms != nullptr) options_.forms->note(relation.span, judgement);
    step.verdict = Verdict::given;
    step.route = "condition of the equation beside it";
    return;
  }
  const bool open = judgement.verdict == Verdict::refuted || judgement.verdict == Verdict::undecided ||
                    judgement.verdict == Verdict::not_understood;
  if (open && proves_with_dots_on_vectors(parsed, which, *claim, step)) return;
  if (open && context.role == Role::display && claim->recorded == nullptr &&
      proves_alternatives(parsed, step))
    return;
  if (open && may_define && takes_apart(parsed, *left.typed, *right.typed, context, step)) return;
  if (may_replace && redefines(judgement, parsed, *left.typed, *right.typed, context, step)) return;
  heed(parsed, which, *claim, left, right, context, judgement);
  if (options_.forms != nullptr) options_.forms->note(relation.span, judgement);
  if (judgement.verdict == Verdict::refuted && !reading.how().unsummed.empty()) {
    const std::string& index = *reading.how().unsummed.begin();
    const bool labels = can_be_labels(notes_.syntax, parsed, which);
    step.diagnostics = {
        {labels ? DiagnosticKind::ambiguous_reading : DiagnosticKind::free_index_mismatch, relation.span,
         labels ? fmt::format("`{}` can be a label of both sides, or a free index of one side only", index)
                : fmt::format("index `{}` is free on one side and summed on the other", index)}};
    if (labels) step.verdict = Verdict::not_understood;
    return;
  }
  const Op op = tree_[left.typed->id].op;
  const bool symbol_by_cases =
      (op == Op::delta || op == Op::epsilon) && tree_[right.typed->id].op == Op::table;
  if (symbol_by_cases && judgement.verdict == Verdict::proved) {
    judgement.verdict = Verdict::definition;
    judgement.route += ", agrees with the built-in symbol";
  }
  accept(std::move(judgement), step);
}

}  // namespace rigor
