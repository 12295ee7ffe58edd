// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/reading/change.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/among.h"

namespace rigor {
namespace {

/// Does a definition lead to the place?
bool reaches_place(Reading& reading, ExprId id) {
  return std::ranges::any_of(symbols_reached(reading.tree, reading.names.scope, {id}), [&](SymbolId symbol) {
    return change_of(reading, symbol, By::space).kind == Dependence::Kind::variable;
  });
}

/// `partial`: by the time it holds the place; by a letter, all that nothing makes change with it.
Differentiator& differentiator(Reading& reading, const Variable& by, Slot axis, bool partial) {
  const auto dependence_of = [&reading, by, partial](SymbolId symbol) {
    using Kind = Dependence::Kind;
    const Names& names = reading.names;
    if (partial && by == By::time && change_of(reading, symbol, By::space).kind == Kind::variable)
      return Dependence{Kind::constant};
    const Dependence dependence = change_of(reading, symbol, by);
    const bool held = partial && by.by == By::letter && dependence.kind == Kind::varies;
    if (held && !leads_to(names, reading.tree, symbol, by)) return Dependence{Kind::constant};
    if (by == By::space && dependence.kind == Kind::variable) {
      reading.found.differentiates_position = true;
      note_position(reading, symbol);
    }
    const bool guessed = dependence.kind == Kind::varies && !knows_change(names, reading.tree, symbol, by);
    std::vector<SymbolId>& unknown = reading.found.unknown_changes;
    if (guessed && !is_one_of(symbol, unknown)) unknown.push_back(symbol);
    return dependence;
  };
  auto& [budget, known] = reading.derivatives;
  const auto key = std::tuple(by, partial, axis.axis, axis.variable);
  return known.try_emplace(key, reading.tree, by, dependence_of, budget, axis).first->second;
}

ExprId along_axis(Reading& reading, ExprId id, std::uint8_t axis) {
  return derivative_along(reading, id, {axis, {}});
}

ExprId at_axis(ExprTree& tree, ExprId id, std::uint8_t axis) {
  const Slot slot{axis, {}};
  return component_of(tree, id, std::span(&slot, 1));
}

void note_logarithm(Reading& reading, ExprId of) {
  reading.found.differentiates_logarithm =
      reading.found.differentiates_logarithm ||
      std::ranges::any_of(nodes_below(reading.tree, {of}), [&](ExprId id) {
        return reading.tree[id].op == Op::function && reading.tree[id].function == Function::log;
      });
}

/// A column of two rows has no derivatives along three axes.
bool is_of_another_space(Reading& reading, const Typed& typed, Span span) {
  if (typed.rank == 0 || reading.tree[typed.id].axes == AxisSpaces::of(use_space(reading), typed.rank))
    return false;
  unsupported(reading, span, "`\\nabla` acts on vectors of space, not on a column or matrix of another size");
  return true;
}

}  // namespace

Typed rate_of(Reading& reading, Typed typed, int times, bool partial) {
  note_logarithm(reading, typed.id);
  Differentiator& by_time = differentiator(reading, By::time, {}, partial);
  for (int k = 0; k < times; ++k) typed.id = by_time.derivative_or_zero(typed.id);
  return typed;
}

Typed derivative_by(Reading& reading, Typed typed, const Variable& by) {
  note_logarithm(reading, typed.id);
  // What has the rate in it says how it depends on it: the rest of \partial L/\partial\dot q is held.
  const bool holds_the_rest = by.partial && !by.held && reading.tree.symbols[by.letter].derivation &&
                              is_one_of(by.letter, symbols_in(reading.tree, typed.id));
  typed.id = differentiator(reading, by, {}, holds_the_rest).derivative_or_zero(typed.id);
  return typed;
}

ExprId derivative_along(Reading& reading, ExprId id, Slot axis) {
  note_logarithm(reading, id);
  return differentiator(reading, By::space, axis, false).derivative_or_zero(id);
}

bool frame_is_open(Reading& reading, const Typed& typed, Span span) {
  if (typed.rank == 0 || reading.names.scope.frames->empty()) return false;
  const Frame& frame = reading.names.scope.frames->back();
  ambiguous(
      reading, span,
      fmt::format("the vector's change can be meant as seen in `{}` or in `{}`", frame.fixed, frame.rotating),
      {fmt::format("write `\\left(…\\right)_{{\\text{{{}}}}}` or `\\left(…\\right)_{{\\text{{{}}}}}`",
                   frame.fixed, frame.rotating)});
  return true;
}

bool is_total_rate_of_field(Reading& reading, const Typed& typed, Span span) {
  for (const SymbolId symbol : symbols_in(reading.tree, typed.id)) {
    const bool varies = change_of(reading, symbol, By::space).kind == Dependence::Kind::varies;
    if (!varies || !is_field(reading.names, reading.tree, symbol)) continue;
    // A constant of the motion that is defined by places
    if (change_of(reading, symbol, By::time).kind == Dependence::Kind::constant) continue;
    unsupported(
        reading, span,
        fmt::format("the total rate of the field `{}` is not decided", reading.tree.symbols[symbol].name),
        {"`\\frac{\\partial}{\\partial t}` is read, and `(\\mathbf{v}\\cdot\\nabla)`"});
    return true;
  }
  return false;
}

MaybeTyped with_places_open(Reading& reading, Typed typed, Span span) {
  bool open = true;
  const auto by = [&](ExprId id) -> std::optional<ExprId> {
    const ExprNode node = reading.tree[id];
    const NamedDefinition* named =
        definition_of(reading.names.scope, base_of(reading.tree.symbols, node.symbol));
    if (named == nullptr || !reaches_place(reading, named->definition.body)) return std::nullopt;
    const Definition& definition = named->definition;
    const bool plain = definition.symbol == node.symbol && definition.indices.empty() &&
                       definition.particle == no_particle && !definition.by_square;
    open = open && plain;
    if (!plain) return std::nullopt;
    const std::vector<Slot> slots(reading.tree.slots(id).begin(), reading.tree.slots(id).end());
    return component_of(reading.tree, definition.body, slots);
  };
  for (ExprId before = typed.id; open; before = typed.id) {
    typed.id = replaced(reading.tree, typed.id, by);
    if (typed.id == before) return typed;
  }
  return unsupported(
      reading, span,
      "the partial time derivative of a quantity that is defined by the position is not decided");
}

/// Derivatives by coordinates run over the three axes of the common space.
bool has_other_places(Reading& reading, Span span) {
  if (space_of(reading.names.symbols) == common_space) return false;
  unsupported(reading, span, "derivatives by place are read in three dimensions only");
  return true;
}

MaybeTyped apply_nabla(Reading& reading, FieldOperator what, const Typed& operand, Span span) {
  if (is_of_another_space(reading, operand, span)) return std::nullopt;
  if (has_other_places(reading, span)) return std::nullopt;
  ExprTree& tree = reading.tree;
  const bool of_vector = what == FieldOperator::divergence || what == FieldOperator::curl;
  if (of_vector && operand.rank != 1)
    return operand.rank > 1
               ? unsupported(reading, span, "the divergence of a tensor is not decided in this notation")
               : wrong_rank(reading, span, "a divergence or curl is taken of a vector",
                            {"`\\nabla f` is the gradient"});
  if (operand.rank > 1)
    return unsupported(reading, span, "derivatives of tensors are decided in index notation only");
  const auto partial = [&](ExprId id, std::uint8_t axis) { return along_axis(reading, id, axis); };
  const auto along = [&](std::uint8_t i) -> ExprId {
    const auto j = static_cast<std::uint8_t>(i % 3 + 1);
    const auto k = static_cast<std::uint8_t>(j % 3 + 1);
    switch (what) {
      case FieldOperator::gradient:
        return partial(operand.id, i);
      case FieldOperator::divergence:
        return at_axis(tree, partial(operand.id, i), i);
      case FieldOperator::laplacian:
        return partial(partial(operand.id, i), i);
      case FieldOperator::curl:
        break;
    }
    const ExprId subtracted = at_axis(tree, partial(operand.id, k), j);
    const ExprId negated = tree.add({.op = Op::negate, .span = span}, std::span(&subtracted, 1));
    return sum_of(tree, {at_axis(tree, partial(operand.id, j), k), negated}, 0, span);
  };
  const std::vector<ExprId> parts{along(1), along(2), along(3)};
  Typed typed = operand;
  if (what == FieldOperator::gradient) ++typed.rank;
  if (what == FieldOperator::divergence) typed.rank = 0;
  const bool is_sum = what == FieldOperator::divergence || what == FieldOperator::laplacian;
  const auto rank = static_cast<std::uint8_t>(typed.rank);
  typed.id = is_sum ? sum_of(tree, parts, typed.rank, span)
                    : tree.add({.op = Op::tuple, .rank = rank, .span = span}, parts);
  return typed;
}

MaybeTyped directional(Reading& reading, const Typed& along, const Typed& operand, Span span) {
  if (has_other_places(reading, span)) return std::nullopt;
  if (along.rank != 1) return wrong_rank(reading, span, "`(\\mathbf{A}\\cdot\\nabla)` needs a vector");
  if (is_of_another_space(reading, along, span) || is_of_another_space(reading, operand, span))
    return std::nullopt;
  const auto rank = static_cast<std::uint8_t>(operand.rank);
  std::vector<ExprId> terms;
  for (std::uint8_t i = 1; i <= 3; ++i) {
    const ExprId factors[] = {at_axis(reading.tree, along.id, i), along_axis(reading, operand.id, i)};
    terms.push_back(reading.tree.add({.op = Op::multiply, .rank = rank, .span = span}, factors));
  }
  Typed typed = operand;
  merge_letters(typed, along);
  typed.id = sum_of(reading.tree, terms, operand.rank, span);
  return typed;
}

}  // namespace rigor
