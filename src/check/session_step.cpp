// SPDX-License-Identifier: GPL-3.0-or-later
// One step of a chain: definition, assumption or claim.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "check/identity_reading.h"
#include "check/session.h"

namespace rigor {
namespace {

using Clock = std::chrono::steady_clock;

bool contains(const std::vector<SymbolId>& symbols, SymbolId symbol) {
  return std::find(symbols.begin(), symbols.end(), symbol) != symbols.end();
}

}  // namespace

void Session::step(const ParsedChain& parsed, std::size_t which, std::vector<Side>& sides,
                   Elaborator& elaborator, const Context& context) {
  const auto start = Clock::now();
  Step step = new_step(parsed, which, context);
  const WrittenRelation& relation = parsed.written.relations[which];
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
  } else if (relation.kind == RelationKind::other || relation.kind == RelationKind::implies) {
    step.diagnostics.push_back({DiagnosticKind::unsupported, relation.span,
                                fmt::format("the relation `{}` is not decided yet", relation.text)});
  } else if (relation.kind == RelationKind::demanded) {
    step.diagnostics.push_back({DiagnosticKind::unsupported,
                                relation.span,
                                "an equation that is demanded is not a claim",
                                {},
                                {"`rigor: given` makes it an assumption"}});
  } else if (readable) {
    decide_step(parsed, which, sides, elaborator, context, step);
  }
  step.milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  add(std::move(step));
}

void Session::decide_step(const ParsedChain& parsed, std::size_t which, const std::vector<Side>& sides,
                          Elaborator& elaborator, const Context& context, Step& step) {
  const Side& left = sides[which];
  const Side& right = sides[which + 1];
  if (which == 0 && defines(parsed, left, right, context, step)) return;
  Diagnostics mismatches;
  const WrittenRelation& relation = parsed.written.relations[which];
  Elaborator::Mismatch place{relation.span, mismatches};
  const auto equation = elaborator.equation(*left.typed, *right.typed, place);
  step.diagnostics.insert(step.diagnostics.end(), mismatches.begin(), mismatches.end());
  if (!equation) return;
  if (context.role == Role::given) {
    add_assumption(*equation, parsed, context, step);
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
  Judgement judgement =
      judge(tree_, names_,
            {*equation, relation.span, parsed.written.sides[which].span, parsed.written.sides[which + 1].span,
             &elaborator, parsed.written.doubt ? &*parsed.written.doubt : nullptr});
  if (which == 0 && redefines(judgement, parsed, *left.typed, *right.typed, step)) return;
  step.verdict = judgement.verdict;
  const Op op = tree_[left.typed->id].op;
  const bool symbol_by_cases =
      (op == Op::delta || op == Op::epsilon) && tree_[right.typed->id].op == Op::table;
  if (symbol_by_cases && judgement.verdict == Verdict::proved) {
    step.verdict = Verdict::definition;
    judgement.route += ", agrees with the built-in symbol";
  }
  step.route = std::move(judgement.route);
  step.uses = std::move(judgement.uses);
  step.counterexample = std::move(judgement.counterexample);
  step.diagnostics.insert(step.diagnostics.end(), judgement.diagnostics.begin(), judgement.diagnostics.end());
}

/// The left side is one bare symbol with distinct index letters, or none, and nothing free on the right that
/// it does not carry.
std::optional<Definition> Session::as_definition(const Typed& left, const Typed& right) const {
  const ExprNode& node = tree_[left.id];
  if (node.op != Op::symbol || left.rank != right.rank) return std::nullopt;
  Definition definition;
  definition.symbol = node.symbol;
  definition.particle = node.particle;
  definition.body = right.id;
  for (const Slot& slot : tree_.slots(left.id)) {
    const bool repeated = std::any_of(definition.indices.begin(), definition.indices.end(),
                                      [&](IndexId id) { return id == slot.variable; });
    if (slot.axis != 0 || repeated) return std::nullopt;
    definition.indices.push_back(slot.variable);
  }
  const bool letters_fit = std::all_of(right.free.begin(), right.free.end(), [&](const FreeIndex& free) {
    return std::find(definition.indices.begin(), definition.indices.end(), free.id) !=
           definition.indices.end();
  });
  const bool particles_fit =
      std::all_of(right.particles.begin(), right.particles.end(),
                  [&](const FreeParticle& free) { return free.id == definition.particle; });
  const bool all_bound = left.free.size() == definition.indices.size() &&
                         left.particles.size() == (node.particle == no_particle ? 0u : 1u);
  if (!letters_fit || !particles_fit || !all_bound) return std::nullopt;
  if (!is_literal_zero(tree_, right) && right.free.size() != definition.indices.size()) return std::nullopt;
  return is_circular(left, right) ? std::nullopt : std::optional(definition);
}

/// Does the right side lead back to the symbol on the left?
bool Session::is_circular(const Typed& left, const Typed& right) const {
  if (tree_[left.id].op != Op::symbol) return false;
  std::vector<SymbolId> reached;
  std::vector<ExprId> pending{right.id};
  while (!pending.empty()) {
    const ExprId id = pending.back();
    pending.pop_back();
    for (const SymbolId symbol : symbols_in(tree_, id)) {
      if (contains(reached, symbol)) continue;
      reached.push_back(symbol);
      if (const NamedDefinition* definition = names_.definition_of(symbol))
        pending.push_back(definition->definition.body);
    }
  }
  return contains(reached, tree_[left.id].symbol);
}

bool Session::defines(const ParsedChain& parsed, const Side& left, const Side& right, const Context& context,
                      Step& step) {
  if (context.role == Role::claim || context.role == Role::given) return false;
  const auto definition = as_definition(*left.typed, *right.typed);
  if (!definition && context.role == Role::let && is_circular(*left.typed, *right.typed)) {
    names_.mark_used(context.directive);
    step.diagnostics.push_back(
        {DiagnosticKind::circular_definition, step.relation_span,
         fmt::format("`{}` is defined through itself", written(tree_[left.typed->id].span))});
    return true;
  }
  if (!definition) return false;
  const bool named_definition =
      parsed.written.relations[0].kind == RelationKind::defines || context.role == Role::let;
  const bool known = names_.definition_of(definition->symbol) != nullptr;
  const bool seen = names_.seen_in_equation(definition->symbol);
  if (context.role == Role::display && (known || (seen && !named_definition))) return false;
  if (const NamedDefinition* earlier = names_.definition_of(definition->symbol)) {
    if (earlier->origin.directive) names_.mark_used(*earlier->origin.directive);
    step.diagnostics.push_back(
        {DiagnosticKind::redefinition, step.relation_span,
         fmt::format("`{}` replaces `{}`", written(tree_[left.typed->id].span), earlier->origin.text)});
  }
  add_definition(*left.typed, *right.typed, parsed, context, step);
  return true;
}

void Session::add_definition(const Typed& left, const Typed& right, const ParsedChain& parsed,
                             const Context& context, Step& step) {
  const auto definition = as_definition(left, right);
  const std::string name = written(tree_[left.id].span);
  Origin origin{fmt::format("definition {} {}", name, place_name(parsed)), section_, std::nullopt};
  if (context.role == Role::let) {
    origin.text = fmt::format("let {}", name);
    origin.directive = context.directive;
  }
  names_.define({*definition, std::move(origin), 0});
  step.verdict = Verdict::definition;
  step.route = "definition";
}

/// Another section gives a symbol another meaning, in other symbols or as another number: a warning and a new
/// definition. What can be compared with the earlier meaning is a claim, wherever it stands.
bool Session::redefines(const Judgement& judgement, const ParsedChain& parsed, const Typed& left,
                        const Typed& right, Step& step) {
  const auto definition = as_definition(left, right);
  if (!definition) return false;
  const NamedDefinition* earlier = names_.definition_of(definition->symbol);
  if (earlier == nullptr || earlier->origin.directive || earlier->origin.section == section_) return false;
  Question question;
  question.tree = &tree_;
  for (const NamedDefinition& named : names_.definitions()) question.definitions.push_back(named.definition);
  const bool numbers =
      primitive_symbols(question, left.id).empty() && primitive_symbols(question, right.id).empty();
  const bool law = std::any_of(
      judgement.diagnostics.begin(), judgement.diagnostics.end(),
      [](const Diagnostic& diagnostic) { return diagnostic.kind == DiagnosticKind::undeclared_symbol; });
  if (!law && !(numbers && judgement.verdict == Verdict::refuted)) return false;
  step.diagnostics.push_back(
      {DiagnosticKind::redefinition, step.relation_span,
       fmt::format("`{}` has another meaning than in `{}`, which is forgotten from here on",
                   written(tree_[left.id].span), earlier->origin.text)});
  add_definition(left, right, parsed, {}, step);
  return true;
}

void Session::add_assumption(const Equation& equation, const ParsedChain& parsed, const Context& context,
                             Step& step) {
  names_.assume(
      {equation,
       {fmt::format("given {} {} {}", step.left, step.relation, step.right), section_, context.directive},
       0});
  step.verdict = Verdict::given;
  step.route = "assumption";
  if (assumptions_have_a_sample(tree_, names_)) return;
  names_.doubt_last_assumption();
  step.diagnostics.push_back(
      {DiagnosticKind::no_sample,
       parsed.written.span,
       "no sample was found that satisfies this together with the assumptions in force",
       {},
       {"a proof from what cannot be proves nothing"}});
}

}  // namespace rigor
