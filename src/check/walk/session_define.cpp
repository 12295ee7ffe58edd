// SPDX-License-Identifier: GPL-3.0-or-later
// Definitions, rules for derivatives, and assumptions.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/among.h"
#include "check/prose/denial.h"
#include "check/scope/contradiction.h"
#include "check/scope/decomposition.h"
#include "check/walk/session.h"
#include "check/word/prose_words.h"

namespace rigor {
namespace {

constexpr std::size_t most_words_of_a_run_in = 4;  // "Second way."

int order_of(const ExprTree& tree, SymbolId symbol) {
  const auto& derivation = tree.symbols[symbol].derivation;
  return derivation ? derivation->time + derivation->space : 0;
}

}  // namespace

/// The left side is one bare symbol with distinct index letters, or none, and nothing free on the right that
/// it does not carry.
std::optional<Definition> Session::as_definition(const Typed& left, const Typed& right) {
  const ExprNode node = tree_[left.id];
  if (node.op == Op::power && node.exponent == 2) return as_square(left, right);
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
    return is_one_of(free.id, definition.indices);
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

/// `(\Omega_1)^2 = …` says what a number is by its square; of the two, it is the one that is not negative.
std::optional<Definition> Session::as_square(const Typed& left, const Typed& right) {
  Typed base = left;
  base.id = tree_.children(left.id)[0];
  const bool plain = tree_[base.id].op == Op::symbol && tree_.slots(base.id).empty() &&
                     tree_[base.id].particle == no_particle && right.free.empty() && right.particles.empty();
  if (!plain || right.rank != 0 || is_circular(base, right)) return std::nullopt;
  Definition definition;
  definition.symbol = tree_[base.id].symbol;
  definition.body = tree_.add({.op = Op::root, .span = tree_[right.id].span}, std::span(&right.id, 1));
  definition.by_square = true;
  return definition;
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
      if (is_one_of(symbol, reached)) continue;
      reached.push_back(symbol);
      if (const NamedDefinition* definition = names_.definition_of(symbol))
        pending.push_back(definition->definition.body);
    }
  }
  return is_one_of(tree_[left.id].symbol, reached);
}

/// `(\Omega_1)^2` names a number by its square; `v^2 = u^2 + 2as` is a law.
bool Session::stands_in_brackets(SyntaxId power) const {
  return notes_.syntax[power].kind == SyntaxKind::power &&
         notes_.syntax[notes_.syntax.child(power, 0)].kind == SyntaxKind::group;
}

bool Session::defines(const ParsedChain& parsed, const Side& left, const Side& right, const Context& context,
                      Step& step) {
  if (context.role == Role::claim || context.role == Role::given || is_denied(context)) return false;
  const auto definition = as_definition(*left.typed, *right.typed);
  if (!definition && context.role == Role::let && is_circular(*left.typed, *right.typed)) {
    names_.mark_used(context.directive);
    step.diagnostics.push_back(
        {DiagnosticKind::circular_definition, step.relation_span,
         fmt::format("`{}` is defined through itself", written(tree_[left.typed->id].span))});
    return true;
  }
  if (!definition) return false;
  const bool square = tree_[left.typed->id].op == Op::power;
  const bool named_definition =
      parsed.written.relations[0].kind == RelationKind::defines || context.role == Role::let;
  if (square && !named_definition && !stands_in_brackets(parsed.sides[0])) return false;
  const bool rate = tree_.symbols[definition->symbol].derivation.has_value();  // a law, not a name
  const bool known = names_.definition_of(definition->symbol) != nullptr;
  const bool seen = names_.seen_in_equation(definition->symbol);
  if (context.role == Role::display && (known || rate || (seen && !named_definition))) return false;
  if (const NamedDefinition* earlier = names_.definition_of(definition->symbol)) {
    if (is_for_now(context)) {
      step.diagnostics.push_back({DiagnosticKind::bad_directive, step.relation_span,
                                  fmt::format("`{}` has a meaning already, which `where` cannot set aside",
                                              written(tree_[left.typed->id].span)),
                                  earlier_place(*earlier)});
      return true;
    }
    if (earlier->origin.directive) names_.mark_used(*earlier->origin.directive);
    step.diagnostics.push_back(
        {DiagnosticKind::redefinition, step.relation_span,
         fmt::format("`{}` replaces `{}`", written(tree_[left.typed->id].span), earlier->origin.text),
         earlier_place(*earlier)});
  }
  add_definition(*left.typed, *right.typed, parsed, context, step);
  return true;
}

/// Where a symbol was defined before.
std::vector<Label> Session::earlier_place(const NamedDefinition& earlier) const {
  const Span place = tree_[earlier.definition.body].span;
  if (place.empty()) return {};
  return {{place, "the earlier definition"}};
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
  origin.place = notes_.prose.beside[event_].place;
  origin.event = event_;
  origin.conditional = context.role == Role::display && is_conditional();
  origin.on_its_line =
      context.role == Role::display && (parsed.written.doubt || !conditions_beside(parsed).empty());
  origin.of_a_case = context.role == Role::display && is_of_a_case();
  if (names_.is_declared_constant(definition->symbol) && decides() &&
      definition_contradicts(tree_, names_, *definition)) {
    names_.assume({as_equation(tree_, *definition), std::move(origin), 0});
    names_.doubt_last_assumption();
    for (const auto& [directive, constant] : constants_) {
      if (constant == definition->symbol) names_.mark_used(directive);
    }
    withdraw_constants_of_last(tree_, names_);
    step.verdict = Verdict::definition;
    step.route = "definition";
    step.diagnostics.push_back(changing_constant(step.relation_span, name));
    return;
  }
  assume_rules_above(definition->symbol);
  names_.define({*definition, std::move(origin), 0});
  if (!names_.small().empty() && decides())
    compare_orders(as_equation(tree_, *definition), step.relation_span, step.diagnostics);
  step.verdict = Verdict::definition;
  step.route = "definition";
}

Diagnostic Session::changing_constant(Span span, const std::string& name) {
  return {DiagnosticKind::no_sample,
          span,
          fmt::format("`{}` is declared constant, and changes by what it is here", name),
          {},
          {"a proof from what cannot be proves nothing"}};
}

/// What is declared small is of first order, whatever else is said of it.
void Session::compare_orders(const Equation& equation, Span span, Diagnostics& diagnostics) {
  const auto small = small_of_other_order(tree_, names_, equation, options_.cache);
  if (!small) return;
  names_.note_other_order(*small);
  diagnostics.push_back({DiagnosticKind::no_sample,
                         span,
                         fmt::format("`{}` is declared small, which means of first order, and is of another "
                                     "order by what it is here",
                                     tree_.symbols[*small].name),
                         {},
                         {"declare small what its powers are taken of"}});
}

/// What is now defined has derivatives of its own: rules for them are equations from here on.
void Session::assume_rules_above(SymbolId symbol) {
  Names::Scene scene = names_.scene();
  std::erase_if(scene.definitions, [&](const NamedDefinition& rule) {
    const SymbolId known = rule.definition.symbol;
    const bool above = base_of(tree_.symbols, known) == base_of(tree_.symbols, symbol) &&
                       order_of(tree_, known) > order_of(tree_, symbol);
    if (above) scene.assumptions.push_back({as_equation(tree_, rule.definition), rule.origin, rule.depth});
    return above;
  });
  names_.replace(std::move(scene));
}

/// Another display said what the symbol on the left is.
bool Session::may_redefine(const Typed& left, const Typed& right) {
  const auto definition = as_definition(left, right);
  if (!definition) return false;
  const NamedDefinition* earlier = names_.definition_of(definition->symbol);
  return earlier != nullptr && !earlier->origin.directive && earlier->origin.event != event_;
}

/// "Hence", "this gives" conclude from the earlier meaning; "going down, so", "the plate then gives" and,
/// above it, "**Plate.**" speak of another case, unless both stand in one sentence.
bool Session::concludes(const NamedDefinition& earlier) const {
  const ProseBeside& beside = notes_.prose.beside[event_];
  if (!announces_a_conclusion(beside.lead)) return false;
  const std::size_t from = notes_.prose.beside[earlier.origin.event].sentence;
  if (from == beside.sentence) return true;
  if (has_own_words(beside.lead.substr(beside.lead.rfind('\n') + 1))) return false;
  return std::none_of(
      notes_.prose.sentences.begin(), notes_.prose.sentences.end(), [&](const ProseSentence& each) {
        return each.number > from && each.number < beside.sentence && !each.has_display &&
               words_of(each.text).size() <= most_words_of_a_run_in && has_own_words(each.text);
      });
}

/// What the page says not to hold defines nothing.
bool Session::is_denied(const Context& context) const {
  return context.role == Role::display && denial_of(notes_.prose, event_).has_value();
}

/// What does not agree with an earlier meaning is a new one: a warning and a new definition. It is a claim
/// where it is announced as a conclusion, where a `use` says that the earlier meaning holds, and where words
/// may make a case of it. In other symbols it is a new meaning only in another section, else a law.
bool Session::redefines(const Judgement& judgement, const ParsedChain& parsed, const Typed& left,
                        const Typed& right, const Context& context, Step& step) {
  if (context.role != Role::display || !expectations_.empty() || is_denied(context)) return false;
  const NamedDefinition* earlier = names_.definition_of(as_definition(left, right)->symbol);
  const bool law = std::any_of(
      judgement.diagnostics.begin(), judgement.diagnostics.end(),
      [](const Diagnostic& diagnostic) { return diagnostic.kind == DiagnosticKind::undeclared_symbol; });
  const std::string& lead = notes_.prose.beside[event_].lead;
  const bool stated = !concludes(*earlier) && !word_that_demands(lead) && !word_of_a_case(lead);
  const bool elsewhere = law && earlier->origin.section != section_;
  if (!elsewhere && !(judgement.verdict == Verdict::refuted && stated)) return false;
  if (is_used_here(standpoint(parsed), names_, earlier->origin, earlier->definition.symbol)) return false;
  step.diagnostics.push_back(
      {DiagnosticKind::redefinition,
       step.relation_span,
       fmt::format("`{}` has another meaning than in `{}`, which is forgotten from here on",
                   written(tree_[left.id].span), earlier->origin.text),
       earlier_place(*earlier),
       {fmt::format("`rigor: use {}` says that the earlier meaning holds",
                    use_of(names_, tree_, earlier->definition.symbol))}});
  add_definition(left, right, parsed, {}, step);
  return true;
}

/// A part of a sum above is said by the whole.
bool Session::takes_apart(const ParsedChain& parsed, const Typed& left, const Typed& right,
                          const Context& context, Step& step) {
  if (context.role != Role::display || !expectations_.empty() || is_conditional() || is_denied(context))
    return false;
  const auto apart = decomposition(tree_, names_, left.id, right.id, notes_.prose.beside[event_].place);
  if (!apart) return false;
  Names::Scene before = names_.scene();
  take_apart(tree_, names_, *apart, tree_[left.id].symbol);
  if (as_definition(left, right)) {
    add_definition(left, right, parsed, context, step);
    if (find_sample()) return true;
  }
  names_.replace(std::move(before));
  return false;
}

/// Does a definition say already what the symbol is, or how it changes? A second one beside it would be
/// followed without the first: that both hold is an assumption. Of two rules, the one of lower order stays.
bool Session::is_determined(SymbolId symbol) const {
  const auto& definitions = names_.definitions();
  return std::any_of(definitions.begin(), definitions.end(), [&](const NamedDefinition& entry) {
    const SymbolId known = entry.definition.symbol;
    return base_of(tree_.symbols, known) == base_of(tree_.symbols, symbol) &&
           order_of(tree_, known) <= order_of(tree_, symbol);
  });
}

/// `given \dot{\mathbf r} = …`: a derivative is replaced wherever it stands.
bool Session::is_rule(const Typed& left, const Typed& right) {
  const auto definition = as_definition(left, right);
  if (!definition || tree_[left.id].op != Op::symbol) return false;
  return tree_.symbols[definition->symbol].derivation && !is_determined(definition->symbol);
}

/// Rules for the components 1, 2 and 3 of one derivative are a rule for the whole.
bool Session::join_component_rules(const Typed& left) {
  const ExprNode node = tree_[left.id];
  const bool component = node.op == Op::symbol && tree_.symbols[node.symbol].derivation &&
                         tree_.symbols[node.symbol].rank == 1 && node.slot_count == 1 &&
                         node.particle == no_particle;
  if (!component || is_determined(node.symbol)) return false;
  std::array<const NamedAssumption*, 3> rules{};
  for (const NamedAssumption& assumption : names_.assumptions()) {
    const Equation& equation = assumption.equation;
    const bool fits = equation.relation == Relation::equal && tree_[equation.left].op == Op::symbol &&
                      tree_[equation.left].symbol == node.symbol && tree_[equation.left].slot_count == 1;
    const std::uint8_t axis = fits ? tree_.slots(equation.left)[0].axis : std::uint8_t{0};
    if (axis != 0) rules[axis - 1u] = &assumption;
  }
  std::array<ExprId, 3> components{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (rules[k] == nullptr) return false;
    components[k] = rules[k]->equation.right;
    for (const SymbolId symbol : symbols_in(tree_, components[k])) {
      if (symbol == node.symbol) return false;
    }
  }
  const Origin origin = names_.assumptions().back().origin;  // of the last, without which it does not hold
  for (const NamedAssumption* rule : rules) {
    const bool last = rule->origin.directive == origin.directive;  // it stands for all
    if (!last && rule->origin.directive) names_.mark_used(*rule->origin.directive);
  }
  const ExprId whole = tree_.add({.op = Op::tuple, .rank = 1, .span = node.span}, components);
  assume_rules_above(node.symbol);
  names_.define({{node.symbol, {}, no_particle, whole}, origin, 0});
  return true;
}

void Session::add_assumption(const Typed& left, const Typed& right, const Equation& equation,
                             const ParsedChain& parsed, std::size_t which, const Context& context,
                             Step& step) {
  const WrittenChain& written = parsed.written;
  Origin origin{fmt::format("given {} {} {}", step.left, step.relation, step.right), section_,
                context.directive,
                fmt::format("given {} {} {}", text_of(written.sides[which].tokens), step.relation,
                            text_of(written.sides[which + 1].tokens))};
  step.verdict = Verdict::given;
  step.route = "assumption";
  const bool is_doubted = is_in_doubt();  // then that was said where it began
  if (equation.relation == Relation::equal && is_rule(left, right)) {
    const Definition rule = *as_definition(left, right);
    if (is_doubted || !decides() || !definition_contradicts(tree_, names_, rule)) {
      assume_rules_above(rule.symbol);
      names_.define({rule, std::move(origin), 0});
      return;
    }
    names_.assume({equation, std::move(origin), 0});
  } else {
    names_.assume({equation, std::move(origin), 0});
    if (join_component_rules(left) || !decides()) return;
    if (!is_doubted && find_sample() && !last_assumption_contradicts(tree_, names_)) {
      if (!names_.small().empty()) compare_orders(equation, step.relation_span, step.diagnostics);
      return;
    }
  }
  names_.doubt_last_assumption();
  withdraw_constants_of_last(tree_, names_);
  if (is_doubted) return;
  mark_all_given();
  step.diagnostics.push_back(no_sample(parsed.written.span));
}

/// What cannot hold together is used: it is why nothing is decided.
void Session::mark_all_given() {
  for (const NamedAssumption& each : names_.assumptions()) {
    if (each.origin.directive) names_.mark_used(*each.origin.directive);
  }
  for (const NamedDefinition& each : names_.definitions()) {
    const bool rule = tree_.symbols[each.definition.symbol].derivation.has_value();
    if (rule && each.origin.directive) names_.mark_used(*each.origin.directive);
  }
}

bool Session::is_in_doubt() const {
  return std::any_of(names_.assumptions().begin(), names_.assumptions().end(),
                     [](const NamedAssumption& each) { return each.without_sample; });
}

bool Session::find_sample() {
  auto sample = sample_of_assumptions(tree_, names_, sample_, {}, options_.cache);
  if (sample) sample_ = *std::move(sample);
  return sample.has_value();
}

Diagnostic Session::no_sample(Span span) {
  return {DiagnosticKind::no_sample,
          span,
          "no sample was found that satisfies this together with the assumptions in force",
          {},
          {"a proof from what cannot be proves nothing"}};
}

}  // namespace rigor
