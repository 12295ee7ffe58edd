// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/walk/topics.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "base/among.h"
#include "check/doubt/digits.h"
#include "check/doubt/named_elements.h"
#include "check/doubt/row_doubts.h"
#include "check/question/decision_cache.h"
#include "check/question/question.h"
#include "check/question/unread.h"
#include "check/row/row.h"
#include "check/scope/definition.h"
#include "elaborate/name/family.h"

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
                        fmt::format("`{}` is not a claim that can be decided", relation.text),
                        {},
                        {"`rigor: small …` says what is small"}};
    case RelationKind::demanded:
      return Diagnostic{DiagnosticKind::unsupported,
                        relation.span,
                        "an equation that is required is not a claim",
                        {},
                        {"`rigor: given` makes it an assumption"}};
    default:
      return std::nullopt;
  }
}

/// Is only the hole in the way?
bool only_asks(const Diagnostics& diagnostics) {
  bool asks = false;
  for (const Diagnostic& diagnostic : diagnostics) {
    const Severity severity = diagnostic.severity();
    if (diagnostic.kind != DiagnosticKind::hole && severity != Severity::warning) return false;
    asks = asks || diagnostic.kind == DiagnosticKind::hole;
  }
  return asks;
}

/// The earlier report's step at the same place with the same text, which several steps can have if directives
/// are anchored there. It learns which step it is.
RecordedStep* recorded_of(Walk& walk, const Step& step) {
  if (walk.options.recorded == nullptr) return nullptr;
  const LineColumn place = walk.sources.line_column(step.span.file, step.span.begin);
  const auto is_alike = [&](const Step& other) {
    return other.span.file == step.span.file && other.span.begin == step.span.begin &&
           other.source == step.source;
  };
  const auto earlier = static_cast<std::size_t>(std::ranges::count_if(walk.report.steps, is_alike));
  for (RecordedStep& each : *walk.options.recorded) {
    if (each.earlier != earlier || each.line != place.line || each.column != place.column) continue;
    if (each.source != step.source || each.file != walk.sources.path(step.span.file)) continue;
    each.step = walk.report.steps.size();
    return &each;
  }
  return nullptr;
}

bool is_unsettled(const ParsedChain& parsed, Span step) {
  return std::ranges::any_of(parsed.choices, [&](const Choice& choice) {
    return choice.span.begin >= step.begin && choice.span.end <= step.end;
  });
}

/// May it say what the symbol on its left side is?
bool may_define(const Walk& walk, const RowPlace& place, const StepReading& row) {
  const RelationKind relation = row.relation().kind;
  return row.which == 0 && !is_order(relation) && relation != RelationKind::nearly &&
         !is_alternative(place, row.parsed) &&
         !shows_circle_number(walk.tree, walk.names, *row.left().typed, *row.right().typed);
}

/// `E_{2n} = 4E_n`, where the letter shows that no other quantity is meant.
bool speaks_of_family(const Walk& walk, const Typed& left) {
  const ExprNode& node = walk.tree[left.id];
  if (node.op != Op::symbol || definition_of(walk.names.scope, node.symbol) != nullptr) return false;
  const auto member = membership_of(walk.names, node.symbol);
  return member && member->name.letters.contains(member->family.letter);
}

/// `E_1 = \epsilon` below `E_n = n^2\epsilon`. What does not follow may say what another quantity is.
bool follows_from_family(Walk& walk, RowPlace& place, StepReading& row, Step& step) {
  const ExprNode& left = walk.tree[row.left().typed->id];
  if (row.role != Role::display || !decides(walk) || left.op != Op::symbol ||
      definition_of(walk.names.scope, left.symbol) != nullptr || !membership_of(walk.names, left.symbol))
    return false;
  const std::string& lead = beside(place).lead;  // "A pipe with one closed end has": another thing
  if (has_own_words(lead.substr(lead.rfind('\n') + 1))) return false;
  Diagnostics mismatches;
  auto claim = row.reading.claim(row.parsed, row.which, row.first_order, mismatches);
  if (!claim) return false;
  claim->recorded = row.recorded = recorded_of(walk, step);
  claim->explains = row.asked != nullptr;
  define_members(walk.tree, place.names, claim->equation);
  Judgement judgement = judge_here(place, *claim);
  if (judgement.verdict != Verdict::proved) return false;
  if (!walk.request.reads) settle(place, row, *claim, std::move(judgement), step);
  return true;
}

/// Both sides are read.
void follow_row(Walk& walk, RowPlace& place, StepReading& row, const Context& context, Step& step) {
  const Typed& left = *row.left().typed;
  const Typed& right = *row.right().typed;
  const bool may_name = may_define(walk, place, row);
  if (row.unsettled &&
      (!is_claimed(row.role) || (may_name && would_define(walk.tree, walk.names.scope, left, right)))) {
    step.diagnostics.push_back(two_readings(row.parsed));
    return;
  }
  const bool open_bracket = row.reading.reading().found.applied.has_value();
  if (!row.unsettled && !open_bracket && may_name && follows_from_family(walk, place, row, step)) return;
  const bool names_member = row.role == Role::display && decides(walk) && speaks_of_family(walk, left);
  if (!row.unsettled && !open_bracket && may_name && !names_member &&
      defines(walk, row.parsed, row.left(), row.right(), context, step))
    return;
  const bool bare_square = walk.tree[left.id].op == Op::power &&
                           !stands_in_brackets(walk.notes.syntax, row.parsed.sides[0]);  // a law, also anew
  const bool may_rename = may_name && !bare_square && may_redefine(walk, row.parsed, left, right);
  Diagnostics mismatches;
  auto claim = row.reading.claim(row.parsed, row.which, row.first_order, mismatches);
  step.diagnostics.insert(step.diagnostics.end(), mismatches.begin(), mismatches.end());
  if (!claim) return offer_what_is_near_unread(place, row, step);
  claim->recorded = row.recorded = recorded_of(walk, step);
  if (row.role == Role::given)
    return add_assumption(walk, left, right, claim->equation, row.parsed, row.which, context, step);
  if (row.role == Role::let) {
    step.diagnostics.push_back({DiagnosticKind::bad_directive,
                                step.relation_span,
                                "`let` defines one symbol, alone on the left side and not on the right",
                                {},
                                {"`rigor: given` assumes an equation"}});
    return;
  }
  if (!decides(walk) && !may_rename) return;
  define_members(walk.tree, place.names, claim->equation);
  claim->explains = row.asked != nullptr;
  const Reading::Found& found = claim->reading->found;
  const bool two_readings = row.other != nullptr && (found.applied || found.belongs);
  claim->in_both_readings = two_readings;
  if (open_bracket) return settle_in_both(place, row, *claim, judge_here(place, *claim), step);
  auto judgement = ask(place, row, *claim, step);
  if (!judgement) return;
  // What does not follow may give its name another meaning, by which later rows are read.
  const bool may_part = may_name && !row.parsed.written.of_cases;
  if (may_part && is_open(*judgement) && takes_apart(walk, row.parsed, left, right, context, step)) return;
  const bool displayed = row.role == Role::display && row.which == 0;
  if (displayed && renames_cases(walk, *judgement, row.parsed, left, right, step)) return;
  if (may_rename && !two_readings && redefines(walk, *judgement, row.parsed, left, right, context, step))
    return;
  if (walk.request.reads) return;
  if (row.other != nullptr) return settle_in_both(place, row, *claim, *std::move(judgement), step);
  settle(place, row, *claim, *std::move(judgement), step);
}

}  // namespace

Step new_step(const Walk& walk, const ParsedChain& parsed, std::size_t which, const Context& context) {
  const WrittenChain& chain = parsed.written;
  Step step;
  step.relation_span = chain.relations[which].span;
  step.span = cover(cover(chain.sides[which].span, step.relation_span), chain.sides[which + 1].span);
  step.tag = chain.tag;
  step.label = chain.label;
  step.section = walk.section;
  step.left = written_at(walk.sources, chain.sides[which].span);
  step.relation = chain.relations[which].text;
  step.right = written_at(walk.sources, chain.sides[which + 1].span);
  step.source = fmt::format("{} {} {}", step.left, step.relation, step.right);
  if (context.place) step.span = *context.place;
  if (!parsed.signs.empty()) step.source += fmt::format(" ({})", parsed.signs);
  if (parsed.image > 0) step.source += fmt::format(" (cyclic image {})", parsed.image);
  return step;
}

void add_step(Walk& walk, Step step) {
  const auto same = [](const Diagnostic& a, const Diagnostic& b) {
    return a.kind == b.kind && a.span == b.span && a.message == b.message;
  };
  Diagnostics once;
  for (Diagnostic& diagnostic : step.diagnostics) {
    const bool known =
        std::ranges::any_of(once, [&](const Diagnostic& old) { return same(old, diagnostic); });
    if (!known) once.push_back(std::move(diagnostic));
  }
  step.diagnostics = std::move(once);
  walk.report.steps.push_back(std::move(step));
}

/// For the row below.
void leave_if_open(Walk& walk, const Step& step) {
  const auto has = [&](std::initializer_list<DiagnosticKind> kinds) {
    return std::ranges::any_of(step.diagnostics,
                               [&](const Diagnostic& each) { return is_one_of(each.kind, kinds); });
  };
  const bool restricted =
      step.verdict == Verdict::undecided && has({DiagnosticKind::restricted, DiagnosticKind::borrowed});
  const bool unread = step.verdict == Verdict::not_understood && !has({DiagnosticKind::unknown_change});
  walk.above.open_row.reset();
  if (restricted || unread)
    walk.above.open_row = RowBefore{walk.notes.prose.beside[walk.event].paragraph, step.span};
}

void take_step(Walk& walk, const ParsedChain& parsed, std::size_t which, ChainReading& reading,
               ChainReading* other, const Context& context, WrittenStep* asked) {
  const auto start = Clock::now();
  walk.options.cache->begin(walk.options.effort);
  Step step = new_step(walk, parsed, which, context);
  RowPlace place = place_here(walk);
  place.heeds_words = decides(walk) && walk.options.recorded == nullptr && !expects_refuted(walk, parsed);
  place.is_stated = expects_law(walk);
  StepReading row{.parsed = parsed,
                  .which = which,
                  .reading = reading,
                  .role = context.role,
                  .first_order = context.first_order,
                  .unsettled = is_unsettled(parsed, step.span),
                  .other = other,
                  .asked = asked};
  const bool up_to_order = decides(walk) && is_up_to_order(row);
  for (const std::size_t side : {which, which + 1}) {
    if (up_to_order) break;  // they are not read as wholes
    const std::vector<Side>& sides = reading.sides;
    const bool first_mention = which == 0 || side == which + 1;
    const bool blocked_by_it_alone =
        !sides[side].typed && sides[which].typed.has_value() != sides[which + 1].typed.has_value();
    if (!first_mention && !blocked_by_it_alone) continue;
    step.diagnostics.insert(step.diagnostics.end(), sides[side].diagnostics.begin(),
                            sides[side].diagnostics.end());
  }
  if (up_to_order) {
    row.recorded = recorded_of(walk, step);
    decide_up_to_order(place, row, step);
  } else if (parsed.written.condition) {
    const Obstacle& condition = *parsed.written.condition;
    step.diagnostics.push_back(
        {condition.kind, parsed.written.condition_span, condition.message, {}, condition.help});
  } else if (walk.unread_case) {
    step.diagnostics.push_back(*walk.unread_case);
  } else if (const auto reason = why_not_decided(row.relation())) {
    step.diagnostics.push_back(*reason);
    if (context.role == Role::display)
      walk.above.unread_rows.emplace_back(walk.notes.prose.beside[walk.event].place, step.span);
  } else if (context.role == Role::display && place.heeds_words && may_be_cycles(step.left, step.right)) {
    step.diagnostics.push_back({DiagnosticKind::unsupported,
                                step.relation_span,
                                "the numbers in brackets can be permutations, written as cycles",
                                {},
                                {"`rigor: claim …` asks whether it holds for the numbers"}});
  } else if (row.left().typed && row.right().typed) {
    follow_row(walk, place, row, context, step);
    const bool holds = step.verdict == Verdict::proved || step.verdict == Verdict::definition;
    const ExprNode& left = walk.tree[row.left().typed->id];
    if (which == 0 && !holds && left.op == Op::symbol) end_family(walk.names.scope, left.symbol);
  } else {
    offer_what_is_near_unread(place, row, step);
  }
  take_over(walk, std::move(place.found));
  doubt_errors(walk.notes.syntax, walk.names, parsed, which, step.diagnostics);
  if (only_asks(step.diagnostics)) step.verdict = Verdict::undecided;
  const bool assumes = context.role == Role::given || context.role == Role::let;
  if (assumes && step.verdict == Verdict::not_understood) {
    std::string text = step.source;
    std::set<std::string> letters = letters_of(text);
    note_unread(walk.names.scope, {std::move(text), std::move(letters), context.directive});
  }
  step.milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  step.work = walk.options.cache->budget().used();
  if (context.role == Role::display) leave_if_open(walk, step);
  add_step(walk, std::move(step));
}

}  // namespace rigor
