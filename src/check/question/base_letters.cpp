// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/question/base_letters.h"

#include <array>
#include <vector>

#include "base/among.h"

namespace rigor {
namespace {

/// What only runs from one limit of an integral to the other: `x = \sin t` says nothing about
/// `\int_0^1\cos t\,dt`.
bool only_runs(const ExprTree& tree, SymbolId letter, const std::vector<SymbolId>& reached,
               const std::vector<SymbolId>& outside) {
  if (is_one_of(letter, outside)) return false;
  bool runs = false;
  for (const SymbolId symbol : reached) {
    const auto& integral = tree.symbols[base_of(tree.symbols, symbol)].integral;
    if (!integral || !integral->lower || !integral->upper) continue;
    runs = runs || integral->variable == letter;
    for (const Limit& limit : {*integral->lower, *integral->upper}) {
      if (limit.at && is_one_of(letter, symbols_in(tree, *limit.at))) return false;
    }
  }
  return runs;
}

}  // namespace

std::set<SymbolId> base_letters(const ExprTree& tree, const NameScope& scope, const Equation& equation) {
  const std::vector<ExprId> sides{equation.left, equation.right};
  const std::vector<SymbolId> reached = symbols_reached(tree, scope, sides);
  const std::vector<SymbolId> outside = symbols_reached(
      tree, sides, [&](SymbolId symbol) { return body_of_definition(scope, base_of(tree.symbols, symbol)); });
  std::set<SymbolId> letters;
  for (const SymbolId symbol : reached) {
    if (!only_runs(tree, symbol, reached, outside)) letters.insert(base_of(tree.symbols, symbol));
  }
  return letters;
}

std::vector<ExprId> nodes_reached(const ExprTree& tree, const NameScope& scope, std::vector<ExprId> roots) {
  for (const SymbolId symbol : symbols_reached(tree, scope, roots)) {
    if (const auto body = body_of_definition(scope, symbol)) roots.push_back(*body);
  }
  return nodes_below(tree, roots);
}

std::set<SymbolId> written_letters(const ExprTree& tree, const Equation& equation) {
  std::set<SymbolId> letters;
  for (const ExprId side : {equation.left, equation.right}) {
    for (const SymbolId symbol : symbols_in(tree, side)) letters.insert(base_of(tree.symbols, symbol));
  }
  return letters;
}

std::optional<Variable> only_letter_differentiated_by(const ExprTree& tree,
                                                      const std::set<SymbolId>& symbols) {
  std::optional<Variable> found;
  for (const SymbolId symbol : symbols) {
    const auto& derivation = tree.symbols[symbol].derivation;
    if (!derivation) continue;
    for (const Variable& by : derivation->by) {
      if (by.by != By::letter) continue;
      if (by.partial || (found && *found != by)) return std::nullopt;
      found = by;
    }
  }
  return found;
}

bool has_rates(const ExprTree& tree, const std::vector<Equation>& equations,
               const std::optional<Variable>& letter) {
  const auto is_rate = [&](SymbolId symbol) { return orders_of(tree.symbols[symbol], letter).total() > 0; };
  return std::ranges::any_of(equations, [&](const Equation& equation) {
    return std::ranges::any_of(symbols_in(tree, equation.left), is_rate) ||
           std::ranges::any_of(symbols_in(tree, equation.right), is_rate);
  });
}

bool is_assumed_of(const ExprTree& tree, const NameScope& scope, SymbolId letter,
                   const NamedAssumption* but) {
  const auto is_it = [&](SymbolId each) { return base_of(tree.symbols, each) == letter; };
  return std::ranges::any_of(scope.assumptions, [&](const NamedAssumption& assumption) {
    if (&assumption == but) return false;
    const Equation& equation = assumption.equation;
    return std::ranges::any_of(symbols_reached(tree, scope, {equation.left, equation.right}), is_it);
  });
}

bool is_joined(const ExprTree& tree, const NameScope& scope, const Equation& equation) {
  const ExprNode& left = tree[equation.left];
  if (equation.relation != Relation::equal || left.op != Op::symbol || left.slot_count != 1) return false;
  const std::uint8_t axis = tree.slots(equation.left)[0].axis;
  const NamedDefinition* definition = definition_of(scope, left.symbol);
  if (axis == 0 || definition == nullptr || tree[definition->definition.body].op != Op::tuple) return false;
  return tree.children(definition->definition.body)[axis - 1u] == equation.right;
}

Equation length_is_one(ExprTree& tree, SymbolId vector) {
  const Span span = tree.symbols[vector].first_seen;
  ExprNode node{.op = Op::symbol, .rank = 1, .span = span, .symbol = vector};
  Equation equation;
  if (tree.symbols[vector].per_particle) {
    node.particle = tree.add_particle("p");
    equation.particles.push_back(node.particle);
  }
  const ExprId part = tree.add(node);
  const std::array sides{part, part};
  equation.left = tree.add({.op = Op::dot, .span = span}, sides);
  equation.right = tree.add_number(span, "1");
  return equation;
}

}  // namespace rigor
