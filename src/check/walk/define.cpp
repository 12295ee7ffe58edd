// SPDX-License-Identifier: GPL-3.0-or-later
// Definitions, rules for derivatives, and assumptions.
#include "check/walk/topics.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/among.h"
#include "base/ascii.h"
#include "check/law/solves.h"
#include "check/meaning/measured.h"
#include "check/prose/denial.h"
#include "check/question/running_letters.h"
#include "check/row/row.h"
#include "check/scope/contradiction.h"
#include "check/scope/decomposition.h"
#include "check/scope/definition.h"
#include "check/verdict/antiderivatives.h"
#include "check/word/prose_words.h"
#include "elaborate/name/family.h"
#include "elaborate/name/function_value.h"

namespace rigor {
namespace {

/// "The field outside of the ball is", "for $r \ge R$" behind it.
bool says_where(const ProseBeside& beside) {
  const auto names_a_region = [](std::string_view word) {
    return is_one_of(word,
                     {"outside", "inside", "beyond", "within", "interior", "exterior", "between", "for"});
  };
  const std::string lead = lowered(beside.lead);
  const std::string tail = lowered(beside.tail);
  return std::ranges::any_of(words_of(lead), names_a_region) ||
         std::ranges::any_of(words_of(tail), names_a_region);
}

constexpr std::size_t most_words_of_a_run_in = 4;  // "Second way."

/// Where a symbol was defined before.
std::vector<Label> earlier_place(const Walk& walk, const NamedDefinition& earlier) {
  const Span place = walk.tree[earlier.definition.body].span;
  if (place.empty()) return {};
  return {{place, "the earlier definition"}};
}

/// A quantity that is declared small is of first order, whatever else is said about it.
void compare_orders(Walk& walk, const Equation& equation, Span span, Diagnostics& diagnostics) {
  const auto small = small_of_other_order(walk.tree, walk.names, equation, walk.options.cache);
  if (!small) return;
  note_other_order(walk.names.scope, *small);
  diagnostics.push_back(
      {DiagnosticKind::no_sample,
       span,
       fmt::format("`{}` is declared small, which means of first order, but this gives it another order",
                   walk.tree.symbols[*small].name),
       {},
       {"declare small the symbol whose powers it is made of"}});
}

/// What is now defined has derivatives of its own: rules for them are equations from here on.
void assume_rules_above(Walk& walk, SymbolId symbol) {
  if (!walk.tree.symbols.has_derivatives(base_of(walk.tree.symbols, symbol))) return;
  NameScope& scope = walk.names.scope;
  const auto is_above = [&](const NamedDefinition& rule) {
    const SymbolId known = rule.definition.symbol;
    return base_of(walk.tree.symbols, known) == base_of(walk.tree.symbols, symbol) &&
           derivative_order(walk.tree.symbols, known) > derivative_order(walk.tree.symbols, symbol);
  };
  for (const NamedDefinition& rule : scope.definitions) {
    if (!is_above(rule)) continue;
    scope.assumptions.push_back({as_equation(walk.tree, rule.definition), rule.origin, rule.depth});
  }
  scope.definitions.erase_if(is_above);
}

void add_definition(Walk& walk, const Typed& left, const Typed& right, const ParsedChain& parsed,
                    const Context& context, Step& step) {
  const auto definition = as_definition(walk.tree, walk.names.scope, left, right);
  const std::string name = written_at(walk.sources, walk.tree[left.id].span);
  Origin origin{fmt::format("definition {} {}", name, name_of_place(walk.sources, parsed)), walk.section,
                std::nullopt};
  if (context.role == Role::let) {
    origin.text = fmt::format("let {}", name);
    origin.directive = context.directive;
  }
  if (parsed.written.of_cases && context.role == Role::display) {
    step.verdict = Verdict::definition;
    step.route = "definition, for one case";
    return define_case(walk, *definition, parsed, origin.text);
  }
  const RowPlace here = place_here(walk);
  origin.place = walk.notes.prose.beside[walk.event].place;
  origin.event = walk.event;
  origin.conditional = context.role == Role::display && is_conditional(here);
  origin.on_its_line =
      context.role == Role::display &&
      (parsed.written.doubt || !conditions_beside(here, parsed).empty() || is_one_of_the_cases(here, parsed));
  origin.only_counts = parsed.written.only_counts && counts_with(walk.names, definition->symbol) &&
                       conditions_beside(here, parsed).empty() && !is_one_of_the_cases(here, parsed);
  origin.of_a_case = context.role == Role::display && is_of_a_case(here);
  origin.of_a_region = context.role == Role::display && says_where(walk.notes.prose.beside[walk.event]);
  if (is_declared_constant(walk.names.scope, definition->symbol) && decides(walk) &&
      definition_contradicts(walk.tree, walk.names, *definition)) {
    assume(walk.names.scope, {as_equation(walk.tree, *definition), std::move(origin), 0});
    doubt_last_assumption(walk.names.scope);
    add_used(walk, withdraw_constants_of_last(walk.tree, walk.names));
    step.verdict = Verdict::definition;
    step.route = "definition";
    step.diagnostics.push_back(changing_constant(step.relation_span, name));
    return;
  }
  assume_rules_above(walk, definition->symbol);
  const bool general =
      !origin.conditional && (!origin.on_its_line || origin.only_counts) && !origin.of_a_case;
  define(walk.names.scope,
         {*definition, std::move(origin), 0, false, runs_along(walk.names, walk.tree, *definition)});
  if (general) note_family(walk.names, definition->symbol);
  if (!walk.names.scope.small.empty() && decides(walk))
    compare_orders(walk, as_equation(walk.tree, *definition), step.relation_span, step.diagnostics);
  step.verdict = Verdict::definition;
  step.route = "definition";
}

/// "Hence", "this gives" conclude from the earlier meaning; "going down, so", "the plate then gives" and,
/// above it, "**Plate.**" speak of another case, unless both are in one sentence.
bool concludes(const Walk& walk, const NamedDefinition& earlier) {
  const ProseBeside& beside = walk.notes.prose.beside[walk.event];
  if (!announces_a_conclusion(beside.lead)) return false;
  const std::size_t from = walk.notes.prose.beside[earlier.origin.event].sentence;
  if (from == beside.sentence) return true;
  if (has_own_words(beside.lead.substr(beside.lead.rfind('\n') + 1))) return false;
  return std::ranges::none_of(walk.notes.prose.sentences, [&](const ProseSentence& each) {
    return each.number > from && each.number < beside.sentence && !each.has_display &&
           words_of(each.text).size() <= most_words_of_a_run_in && has_own_words(each.text);
  });
}

/// `E = kr \quad (r < R)` and `E = k/r^2 \quad (r > R)`: two meanings, and no contradiction.
bool is_another_case(Walk& walk, const ParsedChain& parsed, const NamedDefinition& earlier) {
  return earlier.origin.on_its_line &&
         (parsed.written.doubt.has_value() || is_one_of_the_cases(place_here(walk), parsed));
}

/// What the page says not to hold defines nothing.
bool is_denied(const Walk& walk, const Context& context) {
  return context.role == Role::display && denial_of(walk.notes.prose, walk.event).has_value();
}

/// Rules for all components of one derivative are a rule for the whole.
bool join_component_rules(Walk& walk, const Typed& left) {
  const ExprNode node = walk.tree[left.id];
  const bool component = node.op == Op::symbol && walk.tree.symbols[node.symbol].derivation &&
                         walk.tree.symbols[node.symbol].rank == 1 && node.slot_count == 1 &&
                         node.particle == no_particle;
  if (!component || is_determined(walk.tree.symbols, walk.names.scope, node.symbol)) return false;
  const Space space = walk.tree.symbols[node.symbol].axes[0];
  std::vector<const NamedAssumption*> rules(space.dimension, nullptr);
  for (const NamedAssumption& assumption : walk.names.scope.assumptions) {
    const Equation& equation = assumption.equation;
    const bool fits = equation.relation == Relation::equal && walk.tree[equation.left].op == Op::symbol &&
                      walk.tree[equation.left].symbol == node.symbol &&
                      walk.tree[equation.left].slot_count == 1;
    const std::uint8_t axis = fits ? walk.tree.slots(equation.left)[0].axis : std::uint8_t{0};
    if (axis != 0) rules[axis - 1u] = &assumption;
  }
  std::vector<ExprId> components(space.dimension);
  for (std::size_t k = 0; k < components.size(); ++k) {
    if (rules[k] == nullptr) return false;
    components[k] = rules[k]->equation.right;
    for (const SymbolId symbol : symbols_in(walk.tree, components[k])) {
      if (symbol == node.symbol) return false;
    }
  }
  const Origin origin =
      walk.names.scope.assumptions.back().origin;  // of the last, without which it does not hold
  for (const NamedAssumption* rule : rules) {
    const bool last = rule->origin.directive == origin.directive;  // it stands for all
    if (!last && rule->origin.directive) walk.used.insert(*rule->origin.directive);
  }
  const ExprId whole = walk.tree.add(
      {.op = Op::tuple, .rank = 1, .span = node.span, .axes = AxisSpaces::of(space, 1)}, components);
  assume_rules_above(walk, node.symbol);
  define(walk.names.scope, {{node.symbol, {}, no_particle, whole}, origin, 0});
  return true;
}

/// `z = \zeta(x, y)` where derivatives by place are written: a surface, on which z is so, and elsewhere not.
bool is_surface(const Walk& walk, SymbolId symbol, const ParsedChain& parsed) {
  if (!is_free_variable(walk.names, walk.tree, symbol, By::space)) return false;
  const SyntaxTree& syntax = walk.notes.syntax;
  const std::vector<SyntaxId> others(parsed.sides.begin() + 1, parsed.sides.end());
  return std::ranges::any_of(nodes_below(syntax, others), [&](SyntaxId id) {
    return syntax[id].kind == SyntaxKind::symbol && is_undecorated(syntax.symbol(id)) &&
           axis_of_letter(syntax.symbol(id).letter) != 0;
  });
}

/// x_p of "A particular solution is", where x is in an equation above.
bool is_particular_solution(const Walk& walk, SymbolId letter) {
  const auto of = letter_of_particular_solution(walk.names, letter);
  const std::string lead = lowered(walk.notes.prose.beside[walk.event].lead);
  return of && seen_in_equation(walk.names.scope, *of) && lead.find("particular") != std::string::npos;
}

/// Z of `p_s = e^{-\beta E_s}/Z, \quad Z = \sum_s e^{-\beta E_s}`: a sum that the same display is divided by,
/// and that nothing before it speaks of.
bool is_sum_of_its_display(const Walk& walk, SymbolId symbol, ExprId right) {
  const Span display = span_of(walk.notes.events[walk.event]);
  const Span first = walk.tree.symbols[symbol].first_seen;
  const ExprNode& node = walk.tree[right];
  const bool adds = node.op == Op::particle_sum ||
                    (node.op == Op::symbol && walk.tree.symbols[node.symbol].integral.has_value());
  return adds && first.file == display.file && first.begin >= display.begin && first.end <= display.end;
}

}  // namespace

bool defines(Walk& walk, const ParsedChain& parsed, const Side& left, const Side& right,
             const Context& context, Step& step) {
  if (context.role == Role::claim || context.role == Role::given || is_denied(walk, context)) return false;
  const auto definition = as_definition(walk.tree, walk.names.scope, *left.typed, *right.typed);
  if (!definition && context.role == Role::let &&
      is_circular(walk.tree, walk.names.scope, *left.typed, *right.typed)) {
    walk.used.insert(context.directive);
    step.diagnostics.push_back({DiagnosticKind::circular_definition, step.relation_span,
                                fmt::format("`{}` is defined through itself",
                                            written_at(walk.sources, walk.tree[left.typed->id].span))});
    return true;
  }
  if (!definition || is_function_value(walk.names, walk.tree, definition->symbol) ||
      has_antiderivative(walk.tree, right.typed->id))
    return false;
  if (context.role == Role::display && is_surface(walk, definition->symbol, parsed)) return false;
  if (context.role == Role::display && is_particular_solution(walk, definition->symbol)) return false;
  // `f(x) = 0` is solved, and is no function that is 0.
  const bool to_be_solved = walk.notes.syntax[parsed.sides[0]].kind == SyntaxKind::term &&
                            walk.tree[left.typed->id].rank == 0 &&
                            walk.tree.is_zero_literal(right.typed->id) &&
                            parsed.written.relations[0].kind != RelationKind::defines &&
                            parsed.assumed.empty() && !is_alternative(place_here(walk), parsed);
  if (context.role == Role::display && to_be_solved) return false;
  // `x = 1 \Rightarrow x^2 = 1`: a case, from which something follows on its line.
  const bool beside_an_arrow = parsed.written.premise || parsed.written.inference != Inference::none;
  if (context.role == Role::display && beside_an_arrow &&
      parsed.written.relations[0].kind != RelationKind::defines)
    return false;
  const bool square = walk.tree[left.typed->id].op == Op::power;
  const bool named_definition =
      parsed.written.relations[0].kind == RelationKind::defines || context.role == Role::let ||
      (context.role == Role::display && is_said_to_explain(place_here(walk), parsed));
  const Equation written{.left = left.typed->id, .right = right.typed->id};
  if (context.role == Role::display && !named_definition &&
      says_values_at_a_moment(place_here(walk), written))
    return false;
  if (square && !named_definition && !stands_in_brackets(walk.notes.syntax, parsed.sides[0])) return false;
  const bool rate = walk.tree.symbols[definition->symbol].derivation.has_value();  // a law, not a name
  const bool known = definition_of(walk.names.scope, definition->symbol) != nullptr;
  const bool seen = seen_in_equation(walk.names.scope, definition->symbol) &&
                    !is_next_case(walk, parsed, definition->symbol) &&
                    !is_sum_of_its_display(walk, definition->symbol, definition->body);
  if (context.role == Role::display && (known || rate || (seen && !named_definition))) return false;
  if (const NamedDefinition* earlier = definition_of(walk.names.scope, definition->symbol)) {
    if (is_for_now(walk, context)) {
      step.diagnostics.push_back({DiagnosticKind::bad_directive, step.relation_span,
                                  fmt::format("`{}` already has a meaning, which `where` cannot replace",
                                              written_at(walk.sources, walk.tree[left.typed->id].span)),
                                  earlier_place(walk, *earlier)});
      return true;
    }
    if (earlier->origin.directive) walk.used.insert(*earlier->origin.directive);
    step.diagnostics.push_back(
        {DiagnosticKind::redefinition, step.relation_span,
         fmt::format("`{}` replaces `{}`", written_at(walk.sources, walk.tree[left.typed->id].span),
                     earlier->origin.text),
         earlier_place(walk, *earlier)});
  }
  add_definition(walk, *left.typed, *right.typed, parsed, context, step);
  return true;
}

Diagnostic changing_constant(Span span, const std::string& name) {
  return {DiagnosticKind::no_sample,
          span,
          fmt::format("`{}` is declared constant, but by this it changes", name),
          {},
          {"contradictory assumptions prove nothing"}};
}

bool may_redefine(Walk& walk, const ParsedChain& parsed, const Typed& left, const Typed& right) {
  const auto definition = as_definition(walk.tree, walk.names.scope, left, right);
  if (!definition) return false;
  const NamedDefinition* earlier = definition_of(walk.names.scope, definition->symbol);
  return earlier != nullptr && !earlier->origin.directive &&
         (earlier->origin.event != walk.event || is_another_case(walk, parsed, *earlier));
}

bool redefines(Walk& walk, const Judgement& judgement, const ParsedChain& parsed, const Typed& left,
               const Typed& right, const Context& context, Step& step) {
  if (context.role != Role::display || !walk.next.expectations.empty() || is_denied(walk, context))
    return false;
  const NamedDefinition* earlier =
      definition_of(walk.names.scope, as_definition(walk.tree, walk.names.scope, left, right)->symbol);
  if (is_another_case(walk, parsed, *earlier)) {
    if (judgement.verdict == Verdict::proved) return false;
    add_definition(walk, left, right, parsed, context, step);
    return true;
  }
  const std::string& lead = walk.notes.prose.beside[walk.event].lead;
  const bool stated = !concludes(walk, *earlier) && !word_that_demands(lead) && !word_of_a_case(lead);
  const bool elsewhere = judgement.verdict == Verdict::law && earlier->origin.section != walk.section;
  if (!elsewhere && !(judgement.verdict == Verdict::refuted && stated)) return false;
  // `\omega_0 = 5.0\,\mathrm{s^{-1}}` is a value of what was defined.
  const bool of_a_value = is_measured(walk.tree, earlier->definition.body);  // the mass of another body
  if (is_measured(walk.tree, right.id) && !symbols_in(walk.tree, right.id).empty() && !of_a_value)
    return false;
  RowPlace here = place_here(walk);
  const bool holds_here = is_used_here(standpoint(here, parsed), walk.names, earlier->origin,
                                       earlier->definition.symbol, here.found.used);
  add_used(walk, here.found.used);
  if (holds_here) return false;
  step.diagnostics.push_back(
      {DiagnosticKind::redefinition,
       step.relation_span,
       fmt::format("`{}` has another meaning than in `{}`, which is forgotten from here on",
                   written_at(walk.sources, walk.tree[left.id].span), earlier->origin.text),
       earlier_place(walk, *earlier),
       {fmt::format("`rigor: use {}` says that the earlier meaning holds",
                    use_of(walk.names, walk.tree, earlier->definition.symbol))}});
  add_definition(walk, left, right, parsed, {}, step);
  return true;
}

bool takes_apart(Walk& walk, const ParsedChain& parsed, const Typed& left, const Typed& right,
                 const Context& context, Step& step) {
  if (context.role != Role::display || !walk.next.expectations.empty() || is_conditional(place_here(walk)) ||
      is_denied(walk, context))
    return false;
  const auto apart =
      decomposition(walk.tree, walk.names, left.id, right.id, walk.notes.prose.beside[walk.event].place);
  if (!apart) return false;
  Held before = held(walk.names.scope);
  take_apart(walk.tree, walk.names, *apart, walk.tree[left.id].symbol);
  if (as_definition(walk.tree, walk.names.scope, left, right)) {
    add_definition(walk, left, right, parsed, context, step);
    if (find_sample(walk)) return true;
  }
  replace(walk.names.scope, std::move(before));
  return false;
}

void add_assumption(Walk& walk, const Typed& left, const Typed& right, const Equation& equation,
                    const ParsedChain& parsed, std::size_t which, const Context& context, Step& step) {
  const WrittenChain& written = parsed.written;
  Origin origin{fmt::format("given {} {} {}", step.left, step.relation, step.right), walk.section,
                context.directive,
                fmt::format("given {} {} {}", text_of(written.sides[which].tokens), step.relation,
                            text_of(written.sides[which + 1].tokens))};
  step.verdict = Verdict::given;
  step.route = "assumption";
  const bool is_doubted = is_in_doubt(walk);  // then that was said where it began
  if (equation.relation == Relation::equal && is_rule(walk.tree, walk.names.scope, left, right)) {
    const Definition rule = *as_definition(walk.tree, walk.names.scope, left, right);
    if (is_doubted || !decides(walk) || !definition_contradicts(walk.tree, walk.names, rule)) {
      assume_rules_above(walk, rule.symbol);
      define(walk.names.scope, {rule, std::move(origin), 0});
      return;
    }
    assume(walk.names.scope, {equation, std::move(origin), 0});
  } else {
    assume(walk.names.scope, {equation, std::move(origin), 0});
    if (join_component_rules(walk, left) || !decides(walk)) return;
    if (!is_doubted && find_sample(walk) && !last_assumption_contradicts(walk.tree, walk.names)) {
      if (!walk.names.scope.small.empty())
        compare_orders(walk, equation, step.relation_span, step.diagnostics);
      return;
    }
  }
  doubt_last_assumption(walk.names.scope);
  add_used(walk, withdraw_constants_of_last(walk.tree, walk.names));
  if (is_doubted) return;
  mark_all_given(walk);
  step.diagnostics.push_back(no_sample(parsed.written.span));
}

void mark_all_given(Walk& walk) {
  for (const NamedAssumption& each : walk.names.scope.assumptions) {
    if (each.origin.directive) walk.used.insert(*each.origin.directive);
  }
  for (const NamedDefinition& each : walk.names.scope.definitions) {
    const bool rule = walk.tree.symbols[each.definition.symbol].derivation.has_value();
    if (rule && each.origin.directive) walk.used.insert(*each.origin.directive);
  }
}

bool is_in_doubt(const Walk& walk) {
  return std::ranges::any_of(walk.names.scope.assumptions,
                             [](const NamedAssumption& each) { return each.without_sample; });
}

bool find_sample(Walk& walk) {
  auto sample = sample_of_assumptions(walk.tree, walk.names, walk.sample, {}, walk.options.cache);
  if (sample) walk.sample = *std::move(sample);
  return sample.has_value();
}

Diagnostic no_sample(Span span) {
  return {DiagnosticKind::no_sample,
          span,
          "no sample was found that satisfies this together with the assumptions in force",
          {},
          {"contradictory assumptions prove nothing"}};
}

}  // namespace rigor
