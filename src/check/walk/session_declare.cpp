// SPDX-License-Identifier: GPL-3.0-or-later
// What directives say of symbols, axes and frames.
#include <fmt/format.h>

#include <algorithm>

#include "check/scope/contradiction.h"
#include "check/scope/frame.h"
#include "check/walk/session.h"
#include "expr/calculus/differentiate.h"

namespace rigor {

/// Without a directive, one symbol with mixed indices (`\lambda_{i'j}`) gives the primed axes.
void Session::imply_primed_axes() {
  if (names_.sightings.mixed_axes.size() != 1) return;
  const std::string& letter = *names_.sightings.mixed_axes.begin();
  const bool told = std::any_of(notes_.events.begin(), notes_.events.end(), [&](const Event& event) {
    const auto* placed = std::get_if<PlacedDirective>(&event);
    if (placed == nullptr || placed->directive.kind == DirectiveKind::basis) return placed != nullptr;
    const std::vector<SyntaxId>& symbols = placed->directive.symbols;
    return placed->directive.kind == DirectiveKind::rotation &&
           std::any_of(symbols.begin(), symbols.end(),
                       [&](SyntaxId id) { return notes_.syntax.symbol(id).letter == letter; });
  });
  if (told) return;
  const SymbolId symbol = names_.resolve(tree_, {letter, 2, false}, letter, {});
  tree_.symbols[symbol].rotation = true;
  tree_.symbols[symbol].declared = true;
  names_.set_primed_axes(symbol);
}

void Session::declare(const Directive& directive) {
  if (directive.kind == DirectiveKind::units) return declare_units(directive);
  if (directive.kind == DirectiveKind::use) return declare_use(directive);
  for (const SyntaxId id : directive.symbols) {
    switch (directive.kind) {
      case DirectiveKind::particles:
        names_.declare_particles(notes_.syntax.symbol(id).letter, directive.number);
        break;
      case DirectiveKind::constant:
      case DirectiveKind::variable:
      case DirectiveKind::small:
      case DirectiveKind::for_all:
      case DirectiveKind::frame:
        declare_elaborated(directive, id);
        break;
      case DirectiveKind::basis:
        declare_basis(directive, id);
        break;
      default:
        declare_symbol(directive, id);
    }
  }
}

/// A symbol, or a component, as it is read in an equation; a plain letter of a vector means the vector.
std::optional<Typed> Session::read_declared(SyntaxId id) {
  Diagnostics own;
  Elaborator elaborator(notes_.syntax, tree_, names_, read_letters(notes_.syntax, {id}, names_), own);
  std::optional<Typed> typed = elaborator.expression(id);
  if (typed && tree_[typed->id].op == Op::length) {
    typed->id = tree_.children(typed->id)[0];
    typed->rank = tree_[typed->id].rank;
  }
  if (typed && tree_[typed->id].op == Op::symbol) return typed;
  if (own.empty())
    own.push_back({DiagnosticKind::bad_directive, notes_.syntax[id].span, "this is not a symbol"});
  report_.diagnostics.insert(report_.diagnostics.end(), own.begin(), own.end());
  return std::nullopt;
}

void Session::declare_elaborated(const Directive& directive, SyntaxId id) {
  const std::optional<Typed> typed = read_declared(id);
  if (typed) declare_read(directive, *typed);
}

void Session::declare_read(const Directive& directive, const Typed& typed) {
  const SymbolId symbol = tree_[typed.id].symbol;
  switch (directive.kind) {
    case DirectiveKind::frame:
      if (!names_.frames().empty()) {
        report_.diagnostics.push_back(
            {DiagnosticKind::unsupported,
             directive.span,
             fmt::format("the frame `{}` is in force here, and components are along its axes",
                         names_.frames().back().rotating),
             {},
             {"a new section ends it"}});
        return;
      }
      if (typed.rank != 1) {
        report_.diagnostics.push_back(
            {DiagnosticKind::bad_directive, tree_[typed.id].span, "an angular velocity is a vector"});
        return;
      }
      if (auto why =
              declare_frame(tree_, names_, directive.rotating, directive.fixed, typed.id, directive.number))
        report_.diagnostics.push_back({DiagnosticKind::unsupported, directive.span, std::move(*why)});
      dimensions_.declare_angular_velocity(typed.id);
      return;
    case DirectiveKind::constant:
      declare_constant(directive, typed);
      return;
    case DirectiveKind::variable:
      constants_.emplace_back(directive.number, symbol);
      names_.declare_variable(symbol);
      return;
    case DirectiveKind::for_all:
      for_all_.emplace_back(directive.number, symbol);
      names_.mean_for_all(tree_.symbols, symbol);
      return;
    default:
      declare_small(directive, typed);
  }
}

/// What is small is meant for all small values.
void Session::declare_small(const Directive& directive, const Typed& typed) {
  SmallQuantity small{.quantity = typed.free.empty() ? typed.id : whole_symbol(typed),
                      .directive = directive.number};
  for (const FreeParticle& particle : typed.particles) small.particles.push_back(particle.id);
  names_.mean_for_all(tree_.symbols, tree_[typed.id].symbol);
  names_.declare_small(std::move(small));
}

/// `I_i` names the whole I.
ExprId Session::whole_symbol(const Typed& typed) {
  ExprNode node = tree_[typed.id];
  node.rank = static_cast<std::uint8_t>(tree_.symbols[node.symbol].rank);
  return tree_.add(node);
}

/// A symbol is constant as a whole; of a single component the rate is 0.
void Session::declare_constant(const Directive& directive, const Typed& typed) {
  const auto slots = tree_.slots(typed.id);
  const bool component =
      std::any_of(slots.begin(), slots.end(), [](const Slot& slot) { return slot.axis != 0; });
  const SymbolId symbol = tree_[typed.id].symbol;
  constants_.emplace_back(directive.number, symbol);
  if (!component) {
    names_.declare_constant(symbol, directive.number);
    assume_rates_vanish(directive, symbol);
    check_constant(directive);
    return;
  }
  Equation equation;
  const std::vector<Slot> at(slots.begin(), slots.end());
  equation.left = tree_.add({.op = Op::symbol,
                             .span = tree_[typed.id].span,
                             .symbol = tree_.symbols.derivative(symbol, By::time),
                             .particle = tree_[typed.id].particle},
                            {}, at);
  equation.right = tree_.add_number(tree_[typed.id].span, "0");
  for (const FreeParticle& particle : typed.particles) equation.particles.push_back(particle.id);
  names_.assume({equation, {directive.text, section_, directive.number}, 0});
  check_constant(directive);
}

/// What was given of a rate before is 0.
void Session::assume_rates_vanish(const Directive& directive, SymbolId symbol) {
  std::vector<Definition> rules;
  for (const NamedDefinition& named : names_.definitions()) {
    const auto& of = tree_.symbols[named.definition.symbol].derivation;
    if (!of || of->base != symbol || of->time == 0) continue;
    rules.push_back(named.definition);
    if (named.origin.directive) names_.mark_used(*named.origin.directive);
  }
  for (const Definition& rule : rules) {
    const ExprNode body = tree_[rule.body];
    Equation equation;
    equation.left = rule.body;
    equation.right = zero_of_rank(tree_, body.span, body.rank);
    equation.indices = rule.indices;
    if (rule.particle != no_particle) equation.particles.push_back(rule.particle);
    names_.assume({equation, {directive.text, section_, directive.number}, 0});
  }
}

/// What is constant, and yet changes by its definition above or by the assumptions.
void Session::check_constant(const Directive& directive) {
  if (!decides()) return;
  const SymbolId symbol = constants_.back().second;
  if (const NamedDefinition* named = names_.definition_of(symbol)) {
    const NamedDefinition changing = *named;
    if (definition_contradicts(tree_, names_, changing.definition)) {
      names_.forget_definition(symbol);
      names_.assume({as_equation(tree_, changing.definition), changing.origin, 0});
      names_.doubt_last_assumption();
      names_.withdraw_constant(symbol);
      names_.mark_used(directive.number);
      report_.diagnostics.push_back(changing_constant(directive.span, tree_.symbols[symbol].name));
      return;
    }
  }
  if (names_.assumptions().empty() || is_in_doubt() || find_sample()) return;
  mark_all_given();
  Equation impossible;
  impossible.left = tree_.add_number(directive.span, "0");
  impossible.right = tree_.add_number(directive.span, "1");
  names_.assume({impossible, {directive.text, section_, directive.number}, 0});
  names_.doubt_last_assumption();
  report_.diagnostics.push_back(no_sample(directive.span));
}

/// `basis \mathbf{e}_{i'}`: primed axes of any direction.
void Session::declare_basis(const Directive& directive, SyntaxId id) {
  const WrittenSymbol& symbol = notes_.syntax.symbol(id);
  if (symbol.lower.size() != 1 || symbol.lower[0].primes == 0) {
    report_.diagnostics.push_back({DiagnosticKind::bad_directive,
                                   notes_.syntax[id].span,
                                   "a basis has a primed index",
                                   {},
                                   {"e.g. `basis \\mathbf{e}_{i'}`"}});
    return;
  }
  Symbol rotation;
  rotation.name = "\\mathbf{e}'";
  rotation.rotation = true;
  names_.set_primed_axes(
      names_.declare(tree_, {"\\mathbf{e}'", 2, false}, std::move(rotation), directive.number));
  names_.mark_used(directive.number);
}

/// The primed axes are those of the rotation that is written with one primed index, or of the first.
void Session::declare_rotation(const Directive& directive, const NameKey& key, SymbolId symbol) {
  const auto& mixed = names_.sightings.mixed_axes;
  if (!mixed.contains(key.base) && (!mixed.empty() || names_.primed_axes())) return;
  names_.set_primed_axes(symbol);
  if (mixed.contains(key.base)) names_.mark_used(directive.number);
}

/// A plain letter that would be the length of a vector is a number of its own where it is given a meaning.
void Session::declare_for_now(const Directive& directive, SyntaxId id) {
  if (notes_.syntax[id].kind != SyntaxKind::symbol) return;
  const WrittenSymbol& symbol = notes_.syntax.symbol(id);
  const WrittenName name = take_apart(symbol, Letters{}, names_);
  const bool plain = symbol.face == Face::plain && symbol.accent == Accent::none && symbol.dots == 0;
  const NameKey key{name.base, 0, name.per_particle()};
  if (!plain || !name.axes.empty() || names_.find(key)) return;
  Symbol declared;
  declared.name = key.base;
  declared.first_seen = notes_.syntax[id].span;
  names_.declare(tree_, key, std::move(declared), directive.number);
}

void Session::declare_symbol(const Directive& directive, SyntaxId id) {
  const WrittenSymbol& symbol = notes_.syntax.symbol(id);
  const WrittenName name = take_apart(symbol, Letters{}, names_);
  const bool digits = std::all_of(name.axes.begin(), name.axes.end(),
                                  [](const WrittenIndex& axis) { return axis.form == IndexForm::digit; });
  const bool labels = digits || directive.kind == DirectiveKind::scalar;  // `scalar \omega_n`
  NameKey key{labels ? with_labels(name.base, name.axes) : name.base, 0, name.per_particle()};
  const int axes = labels ? 0 : static_cast<int>(name.axes.size());
  switch (directive.kind) {
    case DirectiveKind::vector:
      key.rank = 1;
      break;
    case DirectiveKind::tensor:
      key.rank = axes > 0 ? axes : 2;
      break;
    case DirectiveKind::rotation:
      key.rank = 2;
      break;
    default:
      break;
  }
  Symbol declared;
  declared.name = name.axes.empty() && name.particles.empty() ? written(notes_.syntax[id].span) : key.base;
  if (key.rank == 1 && !name.particles.empty()) declared.name = fmt::format("\\mathbf{{{}}}", key.base);
  declared.symmetric = directive.symmetric && key.rank == 2;
  declared.rotation = directive.kind == DirectiveKind::rotation;
  declared.unit = key.rank == 1 && (directive.unit || symbol.accent == Accent::hat);
  declared.first_seen = notes_.syntax[id].span;
  const SymbolId declared_symbol = names_.declare(tree_, key, std::move(declared), directive.number);
  if (directive.polar) mirrored_[declared_symbol] = *directive.polar;
  if (directive.kind == DirectiveKind::rotation) declare_rotation(directive, key, declared_symbol);
  const bool whole = symbol.face == Face::plain && symbol.accent != Accent::hat && axes == 0;
  if (whole && key.rank > 0) names_.declare_plain(key);
}

}  // namespace rigor
