// SPDX-License-Identifier: GPL-3.0-or-later
// One step of a chain: what its relation asks, and the verdict.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "check/session.h"
#include "expr/differentiate.h"

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

bool is_order(RelationKind kind) {
  return kind == RelationKind::less || kind == RelationKind::less_or_equal || kind == RelationKind::greater ||
         kind == RelationKind::greater_or_equal || kind == RelationKind::unequal;
}

/// Vectors and tensors are unequal as a whole: a ≠ b says Σ (a − b)² ≠ 0, over all components.
Equation as_squared_distance(ExprTree& tree, Equation unequal) {
  const Span span = tree[unequal.left].span;
  std::vector<Slot> slots;
  for (int axis = 0; axis < tree[unequal.left].rank; ++axis) slots.push_back({0, tree.add_index("i")});
  ExprId value = component_of(tree, unequal.left, slots);
  if (!tree.is_zero_literal(unequal.right)) {
    const ExprId right = component_of(tree, unequal.right, slots);
    const std::array terms{value, tree.add({.op = Op::negate, .span = span}, std::span(&right, 1))};
    value = tree.add({.op = Op::add, .span = span}, terms);
  }
  value = tree.add({.op = Op::power, .span = span, .exponent = 2}, std::span(&value, 1));
  for (const Slot& slot : slots)
    value = tree.add({.op = Op::index_sum, .span = span, .index = slot.variable}, std::span(&value, 1));
  unequal.left = value;
  unequal.right = tree.add_number(span, "0");
  return unequal;
}

}  // namespace

void Session::step(const ParsedChain& parsed, std::size_t which, Attempt& attempt, const Context& context) {
  const auto start = Clock::now();
  Step step = new_step(parsed, which, context);
  const WrittenRelation& relation = parsed.written.relations[which];
  const std::vector<Side>& sides = attempt.sides;
  for (const std::size_t side : {which, which + 1}) {
    const bool first_mention = which == 0 || side == which + 1;
    const bool blocked_by_it_alone =
        !sides[side].typed && sides[which].typed.has_value() != sides[which + 1].typed.has_value();
    if (!first_mention && !blocked_by_it_alone) continue;
    step.diagnostics.insert(step.diagnostics.end(), sides[side].diagnostics.begin(),
                            sides[side].diagnostics.end());
  }
  const bool readable = sides[which].typed && sides[which + 1].typed;
  if (parsed.written.condition) {
    const Obstacle& condition = *parsed.written.condition;
    step.diagnostics.push_back(
        {condition.kind, parsed.written.condition_span, condition.message, {}, condition.help});
  } else if (const auto reason = why_not_decided(relation)) {
    step.diagnostics.push_back(*reason);
  } else if (readable) {
    decide_step(parsed, which, attempt, context, step);
  }
  step.milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  add(std::move(step));
}

/// The sides as one equation or order, greater turned into less.
std::optional<Claim> Session::claim_of(const ParsedChain& parsed, std::size_t which, const Typed& left,
                                       const Typed& right, Elaborator& elaborator, const Context& context,
                                       Diagnostics& diagnostics) {
  const WrittenRelation& relation = parsed.written.relations[which];
  const bool swapped =
      relation.kind == RelationKind::greater || relation.kind == RelationKind::greater_or_equal;
  Elaborator::Mismatch place{relation.span, diagnostics};
  auto equation = elaborator.equation(swapped ? right : left, swapped ? left : right, place);
  if (!equation) return std::nullopt;
  if (is_order(relation.kind) && relation.kind != RelationKind::unequal && tree_[equation->left].rank > 0) {
    diagnostics.push_back(
        {DiagnosticKind::rank_mismatch, relation.span, "vectors and tensors have no order"});
    return std::nullopt;
  }
  if (relation.kind == RelationKind::less || relation.kind == RelationKind::greater)
    equation->relation = Relation::less;
  if (relation.kind == RelationKind::less_or_equal || relation.kind == RelationKind::greater_or_equal)
    equation->relation = Relation::less_or_equal;
  const bool unequal = relation.kind == RelationKind::unequal;
  const bool as_a_whole = unequal && tree_[equation->left].rank > 0;
  if (unequal && !equation->indices.empty()) {
    diagnostics.push_back({DiagnosticKind::ambiguous_reading,
                           relation.span,
                           "with a free index, unequal can mean every component or the whole",
                           {},
                           {"without indices the whole is meant, as in `\\mathbf{A} \\ne 0`",
                            "with digits a component is meant, as in `A_1 \\ne 0`"}});
    return std::nullopt;
  }
  if (unequal) equation->relation = Relation::unequal;
  if (as_a_whole) *equation = as_squared_distance(tree_, *equation);
  const bool nearly =
      relation.kind == RelationKind::nearly || (context.first_order && !is_order(relation.kind));
  return Claim{.equation = *equation,
               .nearly = nearly,
               .swapped = swapped,
               .as_a_whole = as_a_whole,
               .relation = relation.span,
               .left = parsed.written.sides[which].span,
               .right = parsed.written.sides[which + 1].span,
               .reading = &elaborator,
               .doubt = parsed.written.doubt ? &*parsed.written.doubt : nullptr};
}

/// `\frac12 m\dot r^2` where the velocity is meant: if the letter is wrong and the vector is right, it is
/// read so.
bool Session::proves_with_dots_on_vectors(const ParsedChain& parsed, std::size_t which, const Claim& claim,
                                          Step& step) {
  if (!claim.reading->has_dotted_length()) return false;
  Attempt attempt(*this, parsed, Reading{.no_sum = parsed.written.no_sum, .dots_on_vectors = true});
  const Side& left = attempt.sides[which];
  const Side& right = attempt.sides[which + 1];
  if (!left.typed || !right.typed) return false;
  Diagnostics mismatches;
  const auto other = claim_of(parsed, which, *left.typed, *right.typed, attempt.elaborator, {}, mismatches);
  if (!other) return false;
  Judgement judgement = judge(tree_, names_, *other);
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

void Session::decide_step(const ParsedChain& parsed, std::size_t which, Attempt& attempt,
                          const Context& context, Step& step) {
  const Side& left = attempt.sides[which];
  const Side& right = attempt.sides[which + 1];
  const WrittenRelation& relation = parsed.written.relations[which];
  const bool may_define = which == 0 && !is_order(relation.kind) && relation.kind != RelationKind::nearly;
  if (may_define && defines(parsed, left, right, context, step)) return;
  Diagnostics mismatches;
  auto claim = claim_of(parsed, which, *left.typed, *right.typed, attempt.elaborator, context, mismatches);
  step.diagnostics.insert(step.diagnostics.end(), mismatches.begin(), mismatches.end());
  if (!claim) return;
  claim->recorded = recorded_of(step);
  if (context.role == Role::given) {
    add_assumption(*left.typed, *right.typed, claim->equation, parsed, context, step);
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
  Judgement judgement = judge(tree_, names_, *claim);
  if (may_define && redefines(judgement, parsed, *left.typed, *right.typed, step)) return;
  const bool open = judgement.verdict == Verdict::refuted || judgement.verdict == Verdict::undecided ||
                    judgement.verdict == Verdict::not_understood;
  if (open && proves_with_dots_on_vectors(parsed, which, *claim, step)) return;
  if (judgement.verdict == Verdict::refuted && !attempt.reading.unsummed.empty()) {
    step.diagnostics = {{DiagnosticKind::free_index_mismatch, relation.span,
                         fmt::format("index `{}` is free on one side and summed on the other",
                                     *attempt.reading.unsummed.begin())}};
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
