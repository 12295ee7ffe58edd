// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/notation/derivative.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "elaborate/evidence/evidence.h"
#include "elaborate/name/function_value.h"
#include "elaborate/notation/differential.h"
#include "elaborate/notation/notations.h"
#include "elaborate/reading/change.h"
#include "elaborate/reading/space_time.h"
#include "elaborate/reading/summation.h"
#include "elaborate/symbol/axes.h"
#include "elaborate/symbol/symbol.h"

namespace rigor {

bool is_place(const Reading& reading, const WrittenSymbol& variable) {
  if (!names_a_place(variable)) return false;
  return !variable.lower.empty() || !is_own_variable(*reading.names.symbols.evidence, variable.letter);
}

namespace {

/// `x` in `\partial x/\partial y`: nobody differentiates one coordinate by another, so x is a function of y.
bool is_bare_coordinate(const SyntaxTree& syntax, SyntaxId operand) {
  if (syntax[operand].kind != SyntaxKind::symbol) return false;
  const WrittenSymbol& symbol = syntax.symbol(operand);
  return symbol.face == Face::plain && symbol.lower.empty() && axis_of_letter(symbol.letter) != 0;
}

/// In `\frac{dy}{dx}` y is a function of x as a rule, and no coordinate.
bool depends_on_other_coordinate(Reading& reading, const Typed& operand, const WrittenSymbol& variable,
                                 Span span) {
  for (const SymbolId symbol : symbols_in(reading.tree, operand.id)) {
    const Dependence dependence = change_of(reading, symbol, By::space);
    const bool same = variable.lower.empty() && dependence.axis == axis_of_letter(variable.letter);
    if (dependence.kind != Dependence::Kind::variable || same) continue;
    ambiguous(reading, span,
              fmt::format("`{}` can be a coordinate of its own here, or a function of `{}`",
                          reading.tree.symbols[symbol].name, variable.letter),
              {"`\\partial` holds the other coordinates; `rigor: let` says what it depends on"});
    return true;
  }
  return false;
}

/// The derivative by what `variable` reads as; nothing, and a diagnostic, where it is no plain number.
std::optional<SymbolId> symbol_of_variable(Reading& reading, const WrittenSymbol& variable, Span span,
                                           const Around& around) {
  const auto read = elaborate_symbol(reading, variable, span, around);
  if (!read) return std::nullopt;
  const ExprNode& node = reading.tree[read->id];
  const bool plain = node.op == Op::symbol && read->rank == 0 && node.slot_count == 0 &&
                     node.particle == no_particle && read->free.empty();
  if (plain) return node.symbol;
  unsupported(reading, span, fmt::format("a derivative by this `{}` is not decided", variable.letter),
              {"derivatives by a letter that is a plain number are, and by a rate such as `\\dot q`"});
  return std::nullopt;
}

/// `\partial T/\partial\dot q` where T is defined by q or its rate: how a rate depends on another one is seen
/// only where the definitions are open. What does not lead there stays closed.
Typed with_definitions_open(Reading& reading, Typed typed, const Variable& variable) {
  const auto by = [&](ExprId id) -> std::optional<ExprId> {
    const ExprNode node = reading.tree[id];
    const Symbol& symbol = reading.tree.symbols[node.symbol];
    const bool rate = symbol.order() == symbol.order(By::time);
    const NamedDefinition* named =
        rate ? definition_of(reading.names.scope, base_of(reading.tree.symbols, node.symbol)) : nullptr;
    if (named == nullptr || !named->definition.indices.empty() || named->definition.particle != no_particle ||
        named->definition.by_square || !leads_to(reading.names, reading.tree, node.symbol, variable))
      return std::nullopt;
    Typed body{.id = named->definition.body};
    body = rate_of(reading, body, symbol.order());
    const std::vector<Slot> slots(reading.tree.slots(id).begin(), reading.tree.slots(id).end());
    return component_of(reading.tree, body.id, slots);
  };
  constexpr int most_unfolded = 8;  // definitions of definitions; a circle is none
  for (int k = 0; k < most_unfolded; ++k) {
    const ExprId before = typed.id;
    typed.id = replaced(reading.tree, typed.id, by);
    if (typed.id == before) break;
  }
  return typed;
}

/// `V = \ell^2/2mr^2` with `\ell = mr^2\dot\phi`: a partial derivative by r can hold ℓ, or the rate. Where r
/// is not written beside it, ℓ is only a name, and is unfolded.
std::optional<SymbolId> held_or_unfolded(Reading& reading, ExprId operand, SymbolId letter) {
  const SymbolTable& symbols = reading.tree.symbols;
  const NameScope& scope = reading.names.scope;
  const auto is_it = [&](SymbolId each) { return base_of(symbols, each) == base_of(symbols, letter); };
  std::vector<ExprId> bodies{operand};
  for (const SymbolId symbol : symbols_reached(reading.tree, scope, {operand})) {
    if (const NamedDefinition* named = definition_of(scope, symbol)) bodies.push_back(named->definition.body);
  }
  for (const ExprId body : bodies) {
    const std::vector<SymbolId> written = symbols_in(reading.tree, body);
    if (std::ranges::none_of(written, is_it)) continue;
    for (const SymbolId symbol : written) {
      const NamedDefinition* named = is_it(symbol) ? nullptr : definition_of(scope, base_of(symbols, symbol));
      if (named == nullptr) continue;
      if (std::ranges::any_of(symbols_reached(reading.tree, scope, {named->definition.body}), is_it))
        return symbol;
    }
  }
  return std::nullopt;
}

/// By r, of something that has the vector **r**, or its length, in it?
bool leads_to_vector_of(const Reading& reading, ExprId operand, SymbolId letter) {
  const Names& names = reading.names;
  const NameKey* key = key_of(names.symbols, letter);
  if (key == nullptr) return false;
  const auto vector = find_symbol(names.symbols, {key->base, 1, false});
  if (!vector) return false;
  return std::ranges::any_of(symbols_reached(reading.tree, names.scope, {operand}),
                             [&](SymbolId each) { return base_of(reading.tree.symbols, each) == *vector; });
}

bool has_integral(const ExprTree& tree, ExprId id) {
  return std::ranges::any_of(letters_in(tree, id), [&](SymbolId symbol) {
    return tree.symbols[base_of(tree.symbols, symbol)].integral.has_value();
  });
}

/// What a derivative is by, and what it holds.
struct Differentiation {
  std::span<const WrittenVariable> by;
  bool partial = false;
  std::optional<SymbolId> held = {};
  Span span = {};
  bool of_coordinate = false;  // nobody differentiates one coordinate by another: it depends on that
};

/// By any other letter or rate, `\frac{du}{d\theta}`, `\frac{\partial L}{\partial\dot q}`: a plain number.
MaybeTyped by_letter(Reading& reading, const Typed& operand, const WrittenVariable& variable,
                     const Differentiation& how, const Around& around) {
  const auto letter = symbol_of_variable(reading, variable.symbol, how.span, around);
  if (!letter || frame_is_open(reading, operand, how.span)) return std::nullopt;
  if (leads_to_vector_of(reading, operand.id, *letter))
    return unsupported(reading, how.span,
                       fmt::format("a derivative by `{0}` is not decided beside the vector `\\mathbf{{{0}}}`",
                                   variable.symbol.letter));
  const auto open = how.partial ? held_or_unfolded(reading, operand.id, *letter) : std::nullopt;
  if (open && open != how.held) {
    const std::string& name = reading.tree.symbols[*open].name;
    return ambiguous(reading, how.span,
                     fmt::format("`{}` can be held here, or change with `{}`, by which it is defined", name,
                                 variable.symbol.letter),
                     {fmt::format("a subscript below the derivative, `(…)_{{{}}}`, holds it", name)});
  }
  const bool rate = reading.tree.symbols[*letter].derivation.has_value();
  const Variable by{By::letter, *letter, how.partial, how.held};
  Typed typed = rate ? with_definitions_open(reading, operand, by) : operand;
  for (int k = 0; k < variable.times; ++k) typed = derivative_by(reading, std::move(typed), by);
  return typed;
}

MaybeTyped differentiated(Reading& reading, const Differentiation& how, MaybeTyped operand,
                          const Around& around) {
  for (const WrittenVariable& variable : how.by) {
    if (!operand) return operand;
    if (is_time(variable.symbol)) {
      if (frame_is_open(reading, *operand, how.span) ||
          (!how.partial && is_total_rate_of_field(reading, *operand, how.span)))
        return std::nullopt;
      if (how.partial) operand = with_places_open(reading, *std::move(operand), how.span);
      if (!operand) return operand;
      if (how.partial && has_integral(reading.tree, operand->id))
        return unsupported(reading, how.span,
                           "a partial derivative of an integral by the time is not decided");
      operand = rate_of(reading, std::move(*operand), variable.times, how.partial);
      continue;
    }
    if (!is_place(reading, variable.symbol)) {
      operand = by_letter(reading, *operand, variable, how, around);
      continue;
    }
    if ((!how.partial || how.of_coordinate) &&
        depends_on_other_coordinate(reading, *operand, variable.symbol, how.span))
      return std::nullopt;
    for (int k = 0; operand && k < variable.times; ++k)
      operand = by_coordinate(reading, *operand, variable.symbol, how.span, around);
  }
  return operand;
}

}  // namespace

namespace {

/// `\partial_\mu`, `\partial_0`, `\partial^\mu` and `\Box`; nothing for other indices.
std::optional<MaybeTyped> by_index_of_event(Reading& reading, const Typed& operand, const WrittenIndex& index,
                                            Span span, const Around& around) {
  const Evidence& evidence = *reading.names.symbols.evidence;
  if (index.text == box_letter) {
    if (evidence.space_time.shown && !evidence.space_time.curved) return box_of(reading, operand, span);
    return unsupported(
        reading, span,
        "a square before an operand is d'Alembert's operator, which is read in space-time only; "
        "with `\\,` after it, it is a hole");
  }
  const bool of_time = evidence.space_time.shown && index.text == "0";
  if (of_time || is_space_time_index(evidence, index)) return by_event(reading, operand, index, span, around);
  if (index.text != "\\rho" && index.text != "\\sigma") return std::nullopt;
  return ambiguous(reading, span,
                   fmt::format("`{}` can be an index here, or the variable of the derivative", index.text),
                   {"write `\\frac{\\partial}{\\partial r}` for a derivative by `r`"});
}

}  // namespace

MaybeTyped by_coordinate(Reading& reading, const Typed& operand, const WrittenSymbol& variable, Span span,
                         const Around& around) {
  if (variable.lower.size() == 1) {
    if (auto by_index = by_index_of_event(reading, operand, variable.lower[0], span, around))
      return *std::move(by_index);
  }
  const std::uint8_t axis = variable.lower.empty() ? axis_of_letter(variable.letter) : std::uint8_t{0};
  std::optional<Subscript> along = Subscript{.slots = {{axis, {}}}};
  if (axis == 0) {
    if (any_primed(variable.lower))
      return unsupported(reading, span, "a derivative along a primed axis is not decided");
    along = subscript(reading, variable.lower, span, around);
  }
  if (!along || has_other_places(reading, span)) return std::nullopt;
  auto letters = contraction_of(reading, {{.free = along->free}, operand});
  if (!letters) return std::nullopt;
  Typed typed{.rank = operand.rank, .particles = operand.particles};
  typed.id = derivative_along(reading, operand.id, along->slots[0]);
  return summed(reading.tree, std::move(typed), *std::move(letters));
}

MaybeTyped primed_derivative(Reading& reading, const WrittenSymbol& written, const std::string& variable,
                             Span span, const Around& around) {
  WrittenSymbol bare = written;
  const std::uint8_t times = std::exchange(bare.primes, std::uint8_t{0});
  auto operand = elaborate_symbol(reading, bare, span, around);
  const std::vector<WrittenVariable> by{{{.letter = variable}, times}};
  return differentiated(reading, {by, false, {}, span}, std::move(operand), around);
}

MaybeTyped elaborate_derivative(Reading& reading, SyntaxId id, const Around& around) {
  const SyntaxTree& syntax = reading.syntax;
  const Span span = syntax[id].span;
  const WrittenDerivative& written = syntax.derivative(id);
  if (written.by.empty()) return differential_of(reading, syntax.child(id, 0), span, around);
  if (!written.partial && is_declared(reading.names.symbols, {"d", 0, false}))
    return ambiguous(reading, span, "`d` is declared, and can be a differential here");
  auto operand = elaborate(reading, syntax.child(id, 0), around);
  const bool of_coordinate = is_bare_coordinate(syntax, syntax.child(id, 0));
  return differentiated(reading, {written.by, written.partial, {}, span, of_coordinate}, std::move(operand),
                        around);
}

bool may_hold_by_name(const Reading& reading, SyntaxId id) {
  const SyntaxTree& syntax = reading.syntax;
  while (syntax[id].kind == SyntaxKind::group) id = syntax.child(id, 0);
  if (syntax[id].kind != SyntaxKind::derivative || !syntax.derivative(id).partial) return false;
  return std::ranges::all_of(syntax.derivative(id).by, [&](const WrittenVariable& variable) {
    return variable.symbol.lower.empty() && !is_time(variable.symbol) && !is_place(reading, variable.symbol);
  });
}

MaybeTyped held_derivative(Reading& reading, SyntaxId id, const WrittenIndex& held, const Around& around) {
  const SyntaxTree& syntax = reading.syntax;
  while (syntax[id].kind == SyntaxKind::group) id = syntax.child(id, 0);
  const WrittenDerivative& written = syntax.derivative(id);
  if (!may_hold_by_name(reading, id))
    return unsupported(reading, held.span,
                       fmt::format("nothing says what `{}` means on this derivative", held.text),
                       {"`rigor: frame … rotates with … in …` names two frames"});
  const auto symbol = symbol_of_variable(reading, {.letter = held.text}, held.span, around);
  auto operand = elaborate(reading, syntax.child(id, 0), around);
  if (!symbol) return std::nullopt;
  return differentiated(reading, {written.by, true, *symbol, syntax[id].span}, std::move(operand), around);
}

MaybeTyped frame_derivative(Reading& reading, SyntaxId id, const Frame& frame, bool fixed,
                            const Around& around) {
  const SyntaxTree& syntax = reading.syntax;
  const Span span = syntax[id].span;
  while (syntax[id].kind == SyntaxKind::group) id = syntax.child(id, 0);
  int times = 0;
  MaybeTyped operand;
  if (syntax[id].kind == SyntaxKind::derivative) {
    for (const WrittenVariable& by : syntax.derivative(id).by) {
      if (syntax.derivative(id).partial || !is_time(by.symbol))
        return unsupported(reading, span, "a frame is read only on a derivative `d/dt`");
      times += by.times;
    }
    operand = elaborate(reading, syntax.child(id, 0), around);
  } else if (syntax[id].kind == SyntaxKind::symbol && syntax.symbol(id).dots > 0) {
    WrittenSymbol written = syntax.symbol(id);
    times = std::exchange(written.dots, std::uint8_t{0});
    operand = elaborate_symbol(reading, written, syntax[id].span, around);
  } else {
    return unsupported(reading, span, "a frame is read only on a derivative `d/dt`");
  }
  if (!operand) return operand;
  reading.found.used.insert(frame.directive);
  note(reading, fmt::format("components are along the axes of the frame `{}`", frame.rotating));
  if (!fixed || operand->rank == 0) {
    if (fixed && (!operand->free.empty() || names_an_axis(reading.tree, operand->id)))
      return unsupported(reading, span, "a component's derivative in the fixed frame can be read in two ways",
                         {"differentiate the vector, then take the component"});
    return rate_of(reading, std::move(*operand), times);
  }
  if (operand->rank > 1)
    return unsupported(reading, span, "the derivative of a tensor in the fixed frame is not decided");
  Typed rotation{.rank = 2};
  rotation.id = reading.tree.add({.op = Op::symbol, .rank = 2, .span = span, .symbol = frame.rotation});
  for (int k = 0; k < times; ++k) {
    const Typed turned = rate_of(reading, apply_op(reading.tree, Op::dot, span, 1, {rotation, *operand}));
    *operand = apply_op(reading.tree, Op::dot, span, 1, {turned, rotation});
  }
  return operand;
}

MaybeTyped material_rate(Reading& reading, SyntaxId operand, Span span, const Around& around) {
  const NameKey letter{"D", 0, false};
  if (is_declared(reading.names.symbols, letter)) {
    symbol_named(reading, letter, "D", span);  // the declaration is used
    return unsupported(reading, span, "`D` is declared, and `D/Dt` is the derivative along a motion");
  }
  const std::size_t unknown_before = reading.found.unknown_changes.size();
  const auto typed = elaborate(reading, operand, around);
  if (!typed || frame_is_open(reading, *typed, span)) return std::nullopt;
  const SymbolId flow =
      symbol_named(reading, {"u_{\\text{material}}", 1, false}, "\\mathbf{u}_{\\text{material}}", span);
  Typed along{.rank = 1};
  along.id = reading.tree.add({.op = Op::symbol, .rank = 1, .span = span, .symbol = flow});
  const auto carried = directional(reading, along, *typed, span);
  const auto open = with_places_open(reading, *typed, span);
  if (!carried || !open) return std::nullopt;
  const Typed local = rate_of(reading, *open, 1, true);
  reading.found.unknown_changes.resize(unknown_before);  // it is the motion that is not known
  reading.found.guess = unread("nothing says which motion `D/Dt` follows");
  return apply_op(reading.tree, Op::add, span, typed->rank, {local, *carried});
}

}  // namespace rigor
