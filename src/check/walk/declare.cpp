// SPDX-License-Identifier: GPL-3.0-or-later
// What directives say of symbols, axes and frames.
#include "check/walk/topics.h"

#include <fmt/format.h>

#include <algorithm>

#include "check/scope/contradiction.h"
#include "check/scope/frame.h"
#include "check/walk/state.h"
#include "elaborate/notation/elaborate.h"
#include "expr/calculus/differentiate.h"

namespace rigor {

namespace {

/// A symbol, or a component, as it is read in an equation; a plain letter of a vector means the vector.
std::optional<Typed> read_declared(Walk& walk, SyntaxId id) {
  Diagnostics own;
  Reading reading{walk.notes.syntax, walk.tree, walk.names, read_letters(walk.notes.syntax, {id}, walk.names),
                  own};
  std::optional<Typed> typed = elaborate(reading, id);
  add_used(walk, reading.found.used);
  if (typed && walk.tree[typed->id].op == Op::length) {
    typed->id = walk.tree.children(typed->id)[0];
    typed->rank = walk.tree[typed->id].rank;
  }
  if (typed && walk.tree[typed->id].op == Op::symbol) return typed;
  if (own.empty())
    own.push_back({DiagnosticKind::bad_directive, walk.notes.syntax[id].span, "this is not a symbol"});
  walk.report.diagnostics.insert(walk.report.diagnostics.end(), own.begin(), own.end());
  return std::nullopt;
}

void declare_units(Walk& walk, const Directive& directive) {
  for (std::size_t k = 0; k < directive.symbols.size(); ++k) {
    const SyntaxId id = directive.symbols[k];
    if (const auto typed = read_declared(walk, id))
      walk.ledger.entries.push_back(
          {scope_here(walk),
           UnitLine{typed->id, directive.dimensions[k], walk.notes.syntax[id].span, directive.number}});
  }
}

/// `I_i` names the whole I.
ExprId whole_symbol(Walk& walk, const Typed& typed) {
  ExprNode node = walk.tree[typed.id];
  node.rank = static_cast<std::uint8_t>(walk.tree.symbols[node.symbol].rank);
  return walk.tree.add(node);
}

/// What is small is meant for all small values.
void declare_small(Walk& walk, const Directive& directive, const Typed& typed) {
  SmallQuantity small{.quantity = typed.free.empty() ? typed.id : whole_symbol(walk, typed),
                      .directive = directive.number};
  for (const FreeParticle& particle : typed.particles) small.particles.push_back(particle.id);
  mean_for_all(walk.names.scope, walk.tree[typed.id].symbol);
  declare_small(walk.names.scope, std::move(small));
}

/// What was given of a rate before is 0.
void assume_rates_vanish(Walk& walk, const Directive& directive, SymbolId symbol) {
  std::vector<Definition> rules;
  for (const NamedDefinition& named : walk.names.scope.definitions) {
    const SymbolId of = named.definition.symbol;
    if (base_of(walk.tree.symbols, of) != symbol || walk.tree.symbols[of].order(By::time) == 0) continue;
    rules.push_back(named.definition);
    if (named.origin.directive) walk.used.insert(*named.origin.directive);
  }
  for (const Definition& rule : rules) {
    const ExprNode body = walk.tree[rule.body];
    Equation equation;
    equation.left = rule.body;
    equation.right = zero_of_rank(walk.tree, body.span, body.rank, body.axes);
    equation.indices = rule.indices;
    if (rule.particle != no_particle) equation.particles.push_back(rule.particle);
    assume(walk.names.scope, {equation, {directive.text, walk.section, directive.number}, 0});
  }
}

/// What is constant, and yet changes by its definition above or by the assumptions.
void check_constant(Walk& walk, const Directive& directive) {
  if (!decides(walk)) return;
  const SymbolId symbol = walk.constants.back().second;
  if (const NamedDefinition* named = definition_of(walk.names.scope, symbol)) {
    const NamedDefinition changing = *named;
    if (definition_contradicts(walk.tree, walk.names, changing.definition)) {
      forget_definition(walk.names.scope, symbol);
      assume(walk.names.scope, {as_equation(walk.tree, changing.definition), changing.origin, 0});
      doubt_last_assumption(walk.names.scope);
      add_used(walk, withdraw_constant(walk.names.scope, symbol));
      walk.report.diagnostics.push_back(changing_constant(directive.span, walk.tree.symbols[symbol].name));
      return;
    }
  }
  if (walk.names.scope.assumptions.empty() || is_in_doubt(walk) || find_sample(walk)) return;
  mark_all_given(walk);
  Equation impossible;
  impossible.left = walk.tree.add_number(directive.span, "0");
  impossible.right = walk.tree.add_number(directive.span, "1");
  assume(walk.names.scope, {impossible, {directive.text, walk.section, directive.number}, 0});
  doubt_last_assumption(walk.names.scope);
  walk.report.diagnostics.push_back(no_sample(directive.span));
}

/// A symbol is constant as a whole; of a single component the rate is 0.
void declare_constant(Walk& walk, const Directive& directive, const Typed& typed) {
  const auto slots = walk.tree.slots(typed.id);
  const bool component = std::ranges::any_of(slots, [](const Slot& slot) { return slot.axis != 0; });
  const SymbolId symbol = walk.tree[typed.id].symbol;
  walk.constants.emplace_back(directive.number, symbol);
  if (!component) {
    declare_constant(walk.names.scope, symbol, directive.number);
    assume_rates_vanish(walk, directive, symbol);
    check_constant(walk, directive);
    return;
  }
  Equation equation;
  const std::vector<Slot> at(slots.begin(), slots.end());
  equation.left = walk.tree.add({.op = Op::symbol,
                                 .span = walk.tree[typed.id].span,
                                 .symbol = walk.tree.symbols.derivative(symbol, By::time),
                                 .particle = walk.tree[typed.id].particle},
                                {}, at);
  equation.right = walk.tree.add_number(walk.tree[typed.id].span, "0");
  for (const FreeParticle& particle : typed.particles) equation.particles.push_back(particle.id);
  assume(walk.names.scope, {equation, {directive.text, walk.section, directive.number}, 0});
  check_constant(walk, directive);
}

void declare_read(Walk& walk, const Directive& directive, const Typed& typed) {
  const SymbolId symbol = walk.tree[typed.id].symbol;
  switch (directive.kind) {
    case DirectiveKind::frame:
      if (space_of(walk.names.symbols) != common_space) {
        walk.report.diagnostics.push_back(
            {DiagnosticKind::unsupported, directive.span, "frames are read in three dimensions only"});
        return;
      }
      if (!walk.names.scope.frames->empty()) {
        walk.report.diagnostics.push_back(
            {DiagnosticKind::unsupported,
             directive.span,
             fmt::format("the frame `{}` is in force here, and components are along its axes",
                         walk.names.scope.frames->back().rotating),
             {},
             {"a new section ends it"}});
        return;
      }
      if (typed.rank != 1) {
        walk.report.diagnostics.push_back(
            {DiagnosticKind::bad_directive, walk.tree[typed.id].span, "an angular velocity is a vector"});
        return;
      }
      if (auto why = declare_frame(walk.tree, walk.names, directive.rotating, directive.fixed, typed.id,
                                   directive.number, walk.used))
        walk.report.diagnostics.push_back({DiagnosticKind::unsupported, directive.span, std::move(*why)});
      walk.ledger.entries.push_back({scope_here(walk), FrameLine{typed.id}});
      return;
    case DirectiveKind::constant:
      declare_constant(walk, directive, typed);
      return;
    case DirectiveKind::variable:
      walk.constants.emplace_back(directive.number, symbol);
      declare_variable(walk.names.scope, symbol);
      return;
    case DirectiveKind::for_all:
      walk.for_all.emplace_back(directive.number, symbol);
      mean_for_all(walk.names.scope, symbol);
      return;
    default:
      declare_small(walk, directive, typed);
  }
}

void declare_elaborated(Walk& walk, const Directive& directive, SyntaxId id) {
  const std::optional<Typed> typed = read_declared(walk, id);
  if (typed) declare_read(walk, directive, *typed);
}

/// `basis \mathbf{e}_{i'}`: primed axes of any direction.
void declare_basis(Walk& walk, const Directive& directive, SyntaxId id) {
  const WrittenSymbol& symbol = walk.notes.syntax.symbol(id);
  if (symbol.lower.size() != 1 || symbol.lower[0].primes == 0) {
    walk.report.diagnostics.push_back({DiagnosticKind::bad_directive,
                                       walk.notes.syntax[id].span,
                                       "a basis has a primed index",
                                       {},
                                       {"e.g. `basis \\mathbf{e}_{i'}`"}});
    return;
  }
  if (space_of(walk.names.symbols) != common_space) {
    walk.report.diagnostics.push_back({DiagnosticKind::unsupported, walk.notes.syntax[id].span,
                                       "primed axes are read in three dimensions only"});
    return;
  }
  Symbol rotation;
  rotation.name = "\\mathbf{e}'";
  rotation.rotation = true;
  walk.names.symbols.primed_axes =
      declare(walk.names, walk.tree, {"\\mathbf{e}'", 2, false}, std::move(rotation), directive.number);
  walk.used.insert(directive.number);
}

/// The primed axes are those of the rotation that is written with one primed index, or of the first.
void declare_rotation(Walk& walk, const Directive& directive, const NameKey& key, SymbolId symbol) {
  const auto& mixed = walk.names.symbols.sightings->mixed_axes;
  if (!mixed.contains(key.base) && (!mixed.empty() || walk.names.symbols.primed_axes)) return;
  walk.names.symbols.primed_axes = symbol;
  if (mixed.contains(key.base)) walk.used.insert(directive.number);
}

void declare_symbol(Walk& walk, const Directive& directive, SyntaxId id) {
  const WrittenSymbol& symbol = walk.notes.syntax.symbol(id);
  const WrittenName name = take_apart(symbol, Letters{}, walk.names);
  add_used(walk, name.used);
  const bool digits =
      std::ranges::all_of(name.axes, [](const WrittenIndex& axis) { return axis.form == IndexForm::digit; });
  const bool complex = directive.kind == DirectiveKind::complex;
  const bool bold = complex && symbol.face == Face::vector;
  const bool labels = digits || directive.kind == DirectiveKind::scalar || complex;  // `scalar \omega_n`
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
      key.rank = bold ? 1 : 0;
  }
  key.complex = complex;
  Symbol declared;
  declared.name = name.axes.empty() && name.particles.empty()
                      ? written_at(walk.sources, walk.notes.syntax[id].span)
                      : key.base;
  if (key.rank == 1 && !name.particles.empty()) declared.name = fmt::format("\\mathbf{{{}}}", key.base);
  declared.symmetric = directive.symmetric && key.rank == 2;
  declared.rotation = directive.kind == DirectiveKind::rotation;
  declared.unit = key.rank == 1 && (directive.unit || symbol.accent == Accent::hat);
  declared.first_seen = walk.notes.syntax[id].span;
  if ((declared.rotation || declared.unit) && space_of(walk.names.symbols) != common_space) {
    walk.report.diagnostics.push_back({DiagnosticKind::unsupported, walk.notes.syntax[id].span,
                                       "unit vectors and rotations are read in three dimensions only"});
    return;
  }
  if (const auto space = space_declared_by(walk.names.symbols); space && key.rank > 0)
    walk.used.insert(*space);
  const SymbolId declared_symbol = declare(walk.names, walk.tree, key, std::move(declared), directive.number);
  if (directive.polar) walk.ledger.mirrored[declared_symbol] = *directive.polar;
  if (directive.kind == DirectiveKind::rotation) declare_rotation(walk, directive, key, declared_symbol);
  const bool whole = symbol.face == Face::plain && symbol.accent != Accent::hat && axes == 0;
  if (whole && key.rank > 0) walk.names.symbols.plain.write().insert(placed(walk.names.symbols, key));
}

void take_space(Walk& walk, const Directive& directive) {
  const auto refuse = [&](std::string why) {
    walk.report.diagnostics.push_back({DiagnosticKind::unsupported, directive.span, std::move(why)});
  };
  if (!walk.names.scope.frames->empty())
    return refuse("a frame is in force here, and frames turn in three dimensions");
  if (!enter_space(walk.names, directive.space, directive.dimension, directive.number))
    refuse(fmt::format("these notes have more than {} spaces", most_named_spaces));
}

void declare_use(Walk& walk, const Directive& directive) {
  UseDirective use{directive.number, walk.notes.prose.beside[walk.event].place, {}, directive.places};
  for (const SyntaxId id : directive.symbols) {
    const WrittenName name = take_apart(walk.notes.syntax.symbol(id), Letters{}, walk.names);
    add_used(walk, name.used);
    use.letters.push_back(name.base);
  }
  // A label or a line names the equation by its tag, as its definition does.
  for (const Event& event : walk.notes.events) {
    const auto* display = std::get_if<ParsedDisplay>(&event);
    if (display == nullptr) continue;
    for (const ParsedChain& chain : display->chains) {
      const Span span = chain.written.span;
      const std::string line = fmt::format("line {}", walk.sources.line_column(span.file, span.begin).line);
      const bool named = std::ranges::any_of(directive.places, [&](const std::string& place) {
        return place == line || (!chain.written.label.empty() && place == chain.written.label);
      });
      if (named) use.places.push_back(name_of_place(walk.sources, chain));
    }
  }
  walk.above.uses.push_back(std::move(use));
}

}  // namespace

void take_declaration(Walk& walk, const Directive& directive) {
  if (directive.kind == DirectiveKind::units) return declare_units(walk, directive);
  if (directive.kind == DirectiveKind::use) return declare_use(walk, directive);
  if (directive.kind == DirectiveKind::space) return take_space(walk, directive);
  for (const SyntaxId id : directive.symbols) {
    switch (directive.kind) {
      case DirectiveKind::particles:
        declare_particles(walk.names, walk.notes.syntax.symbol(id).letter, directive.number);
        break;
      case DirectiveKind::constant:
      case DirectiveKind::variable:
      case DirectiveKind::small:
      case DirectiveKind::for_all:
      case DirectiveKind::frame:
        declare_elaborated(walk, directive, id);
        break;
      case DirectiveKind::basis:
        declare_basis(walk, directive, id);
        break;
      default:
        declare_symbol(walk, directive, id);
    }
  }
}

void declare_for_now(Walk& walk, const Directive& directive, SyntaxId id) {
  if (walk.notes.syntax[id].kind != SyntaxKind::symbol) return;
  const WrittenSymbol& symbol = walk.notes.syntax.symbol(id);
  const WrittenName name = take_apart(symbol, Letters{}, walk.names);
  add_used(walk, name.used);
  const bool plain = symbol.face == Face::plain && symbol.accent == Accent::none && symbol.dots == 0;
  const NameKey key{name.base, 0, name.per_particle()};
  if (!plain || !name.axes.empty() || find_symbol(walk.names.symbols, key)) return;
  Symbol declared;
  declared.name = key.base;
  declared.first_seen = walk.notes.syntax[id].span;
  declare(walk.names, walk.tree, key, std::move(declared), directive.number);
}

}  // namespace rigor
