// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/row/series_equation.h"

#include <algorithm>

#include "base/among.h"
#include "check/question/decision_cache.h"
#include "check/question/question.h"
#include "check/scope/definition.h"
#include "expr/calculus/differentiate.h"
#include "expr/calculus/power_series.h"

namespace rigor {
namespace {

constexpr int most_poles = 4;  // x^4 may divide

}  // namespace

/// What holds of the letter alone, so that all other symbols can be held while it goes to 0.
std::optional<Equation> with_letter_open(const SeriesPlace& place, Equation equation, SymbolId letter) {
  constexpr int most_rounds = 20;
  if (definition_of(place.names.scope, letter) != nullptr) return std::nullopt;
  const auto speaks = [&](ExprId id) {
    return std::ranges::any_of(symbols_reached(place.tree, place.names.scope, {id}), [&](SymbolId symbol) {
      return symbol == letter || base_of(place.tree.symbols, symbol) == letter;
    });
  };
  for (const NamedAssumption& assumption : place.names.scope.assumptions) {
    const Equation& said = assumption.equation;
    if (said.relation != Relation::equal || (!speaks(said.left) && !speaks(said.right))) continue;
    if (assumption.origin.directive && place.used != nullptr)
      place.used->insert(*assumption.origin.directive);
    return std::nullopt;
  }
  bool open = true;
  const auto by = [&](ExprId id) -> std::optional<ExprId> {
    const ExprNode node = place.tree[id];
    if (node.symbol == letter) return std::nullopt;
    const NamedDefinition* named = definition_of(place.names.scope, node.symbol);
    const bool derived = place.tree.symbols[node.symbol].derivation.has_value();
    if (named == nullptr && (!derived || !speaks(id))) return std::nullopt;
    if (named != nullptr && !speaks(named->definition.body)) return std::nullopt;
    const bool plain = named != nullptr && named->definition.indices.empty() &&
                       named->definition.particle == no_particle && !named->definition.by_square;
    open = open && plain;
    if (!plain) return std::nullopt;
    const std::vector<Slot> slots(place.tree.slots(id).begin(), place.tree.slots(id).end());
    return component_of(place.tree, named->definition.body, slots);
  };
  for (int round = 0; round < most_rounds && open; ++round) {
    const Equation before = equation;
    equation.left = replaced(place.tree, equation.left, by);
    equation.right = replaced(place.tree, equation.right, by);
    if (equation.left == before.left && equation.right == before.right)
      return open ? std::optional(equation) : std::nullopt;
  }
  return std::nullopt;
}

/// The equations between the coefficients of powers below `power`; nothing where a side has no expansion.
std::optional<std::vector<SeriesEquation>> coefficients(const SeriesPlace& place, const Equation& equation,
                                                        SymbolId letter, int power) {
  const auto is_zero = [&](ExprId term) -> std::optional<bool> {
    const Equation zero{.left = term, .right = place.tree.add_number(place.tree[term].span, "0")};
    const Prepared prepared = prepare(place.tree, place.names, zero);
    if (prepared.too_large) return std::nullopt;
    const Decision decision = decide(place.cache, prepared.question, {.simplest_sample = false});
    if (decision.outcome == Outcome::undecided) return std::nullopt;
    return decision.outcome == Outcome::proved;
  };
  PowerSeriesExpansion expansion(place.tree, letter, power + most_poles, is_zero);
  const auto left = expansion.of(equation.left);
  const auto right = expansion.of(equation.right);
  if (!left || !right || std::min(left->end(), right->end()) < power) return std::nullopt;
  std::vector<SeriesEquation> all;
  const auto at = [&](const PowerSeries& series, ExprId like, int order) {
    const int index = order - series.first;
    if (index >= 0) {
      if (const auto& term = series.terms[static_cast<std::size_t>(index)]) return *term;
    }
    return zero_of_rank(place.tree, place.tree[like].span, place.tree[like].rank, place.tree[like].axes);
  };
  for (int order = std::min(left->first, right->first); order < power; ++order) {
    Equation each = equation;
    each.left = at(*left, equation.left, order);
    each.right = at(*right, equation.right, order);
    all.push_back({order, each});
  }
  return all;
}

std::optional<Equation> equation_up_to(const SeriesPlace& place, const Equation& equation, SymbolId letter,
                                       int power) {
  const auto held = with_letter_open(place, equation, letter);
  const auto parts = held ? coefficients(place, *held, letter, power) : std::nullopt;
  if (!parts || parts->empty()) return std::nullopt;
  ExprTree& tree = place.tree;
  const Span span = tree[equation.left].span;
  const auto make = [&](ExprNode node, const std::vector<ExprId>& children) {
    node.span = span;
    return tree.add(node, children);
  };
  const ExprId base = make({.op = Op::symbol, .symbol = letter}, {});
  // All orders count from the lowest one: multiplied by the highest pole.
  const auto polynomial = [&](ExprId Equation::*side) {
    std::vector<ExprId> terms;
    for (const SeriesEquation& each : *parts) {
      const ExprId term = each.equation.*side;
      const int exponent = each.order - parts->front().order;
      if (exponent == 0) {
        terms.push_back(term);
      } else {
        const ExprId power_of_it = make({.op = Op::power, .exponent = exponent}, {base});
        terms.push_back(make({.op = Op::multiply, .rank = tree[term].rank}, {power_of_it, term}));
      }
    }
    return terms.size() == 1 ? terms[0] : make({.op = Op::add, .rank = tree[terms[0]].rank}, terms);
  };
  Equation whole = *held;
  whole.left = polynomial(&Equation::left);
  whole.right = polynomial(&Equation::right);
  return whole;
}

}  // namespace rigor
