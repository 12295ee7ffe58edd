// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/law/surface.h"

#include <utility>

#include "expr/tree/path.h"

namespace rigor {
namespace {

/// By one variable as often as it is, or by each of two while the other one is held: then the order does not
/// matter.
bool commutes(const Derivation& derivation) {
  const Variable& first = *derivation.by.begin();
  const Variable& last = *derivation.by.rbegin();
  const auto known = derivation.by.count(first) + (first == last ? 0 : derivation.by.count(last));
  return known == derivation.by.size() &&
         (first == last || (first.held == last.letter && last.held == first.letter));
}

}  // namespace

Surface::Surface(ExprTree& tree, Coordinates coordinates, std::set<SymbolId> states)
    : tree_(tree),
      coordinates_(coordinates),
      states_(std::move(states)),
      by_{differentiator(0), differentiator(1)} {}

Differentiator Surface::differentiator(int which) {
  const SymbolId own = which == 0 ? coordinates_.u : coordinates_.v;
  const SymbolId other = which == 0 ? coordinates_.v : coordinates_.u;
  const auto dependence_of = [this, own, other](SymbolId symbol) -> Dependence {
    using Kind = Dependence::Kind;
    if (symbol == own) return {Kind::variable};
    const SymbolId base = base_of(tree_.symbols, symbol);
    return {symbol == other || !states_.contains(base) ? Kind::constant : Kind::varies};
  };
  return {tree_, Variable(By::letter, own, true, other), dependence_of, budget_};
}

Equation Surface::along(const Equation& of, int which) {
  Equation result = of;
  result.left = along(of.left, which);
  result.right = along(of.right, which);
  return result;
}

std::optional<Equation> Surface::rewritten(const Equation& equation, int which) {
  bool failed = false;
  const auto by = [&](ExprId id) -> std::optional<ExprId> {
    if (!tree_.symbols[tree_[id].symbol].derivation) return std::nullopt;
    const auto result = of_derivative(id, which);
    failed = failed || !result;
    return result;
  };
  Equation result = equation;
  result.left = replaced(tree_, equation.left, by);
  result.right = replaced(tree_, equation.right, by);
  if (failed || gave_up()) return std::nullopt;
  return result;
}

std::optional<ExprId> Surface::of_derivative(ExprId node, int which) {
  const SymbolId symbol = tree_[node].symbol;
  const Span span = tree_[node].span;
  const Derivation derivation = *tree_.symbols[symbol].derivation;
  ExprId result = letter(derivation.base, span);
  if (is_differential(tree_.symbols, symbol)) return along(result, which);
  if (!commutes(derivation)) return std::nullopt;
  for (const Variable& by : derivation.by) result = with_held(result, by, span);
  return result;
}

ExprId Surface::with_held(ExprId of, const Variable& by, Span span) {
  if (by.letter == coordinates_.u && by.held == coordinates_.v) return along(of, 0);
  if (by.letter == coordinates_.v && by.held == coordinates_.u) return along(of, 1);
  const ExprId held = letter(*by.held, span);
  const ExprId below = jacobian(letter(by.letter, span), held, span);
  divisors_.push_back(below);
  const std::array parts{jacobian(of, held, span), below};
  return tree_.add({.op = Op::divide, .span = span}, parts);
}

ExprId Surface::letter(SymbolId symbol, Span span) {
  return tree_.add({.op = Op::symbol, .span = span, .symbol = symbol});
}

/// f_u g_v − f_v g_u
ExprId Surface::jacobian(ExprId f, ExprId g, Span span) {
  const auto product = [&](int which) {
    const std::array factors{along(f, which), along(g, 1 - which)};
    return tree_.add({.op = Op::multiply, .span = span}, factors);
  };
  const ExprId first = product(0);
  const ExprId second = product(1);
  const std::array terms{first, tree_.add({.op = Op::negate, .span = span}, std::span(&second, 1))};
  return tree_.add({.op = Op::add, .span = span}, terms);
}

}  // namespace rigor
