// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/scope/contradiction.h"

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "algebra/decide/contradiction.h"
#include "algebra/decide/decide.h"
#include "check/question/at_all_times.h"
#include "check/question/decision_cache.h"
#include "check/question/question.h"
#include "expr/calculus/differentiate.h"

namespace rigor {
namespace {

/// For each assumption, when it is made.
constexpr Limits limits_of_contradictions{.expanded_terms = 6'000,
                                          .steps = 200'000,
                                          .sample_attempts = 40,
                                          .fewest_assumptions = false,
                                          .simplest_sample = false};

/// left = left + 1, which is 0 = 1 in the letters of the equation.
Equation impossible_in(ExprTree& tree, const Equation& equation) {
  const ExprNode left = tree[equation.left];
  const std::array terms{equation.left, filled(tree, tree.add_number(left.span, "1"), left.rank, left.axes)};
  Equation impossible = equation;
  impossible.relation = Relation::equal;
  impossible.right = tree.add({.op = Op::add, .rank = left.rank, .span = left.span}, terms);
  return impossible;
}

std::set<SymbolId> bases_of(const ExprTree& tree, const Equation& equation) {
  std::set<SymbolId> bases;
  for (const ExprId side : {equation.left, equation.right}) {
    for (const SymbolId symbol : symbols_in(tree, side)) bases.insert(base_of(tree.symbols, symbol));
  }
  return bases;
}

/// Does the question hold more than the assumption as it stands?
bool may_contradict(const Prepared& prepared) {
  return prepared.has_rates_or_times && prepared.question.assumptions.size() > 1 && !prepared.too_large;
}

bool vanishes(ExprTree& tree, const Names& names, SymbolId symbol, int order, DecisionCache* cache) {
  Equation claim;
  claim.left = tree.add({.op = Op::symbol, .span = tree.symbols[symbol].first_seen, .symbol = symbol});
  claim.right = tree.add_number(tree.symbols[symbol].first_seen, "0");
  const Prepared prepared = prepare(tree, names, claim, 0, Precision::small_order, order);
  return !prepared.too_large &&
         decide(cache, prepared.question, limits_of_contradictions).outcome == Outcome::proved;
}

/// Is it impossible that all derivatives of the body by coordinates are 0?
bool changes_with_place(ExprTree& tree, const Names& names, const Definition& definition) {
  const bool speaks = std::ranges::any_of(symbols_in(tree, definition.body), [&](SymbolId each) {
    return is_free_variable(names, tree, each, By::space);
  });
  if (!speaks || !definition.indices.empty() || definition.particle != no_particle) return false;
  Question question;
  DerivativeBudget budget;
  const auto dependence_of = [&](SymbolId symbol) {
    return change(names, tree, symbol, By::space).dependence;
  };
  for (std::uint8_t axis = 1; axis <= 3; ++axis) {
    Differentiator differentiate(tree, By::space, dependence_of, budget, {axis, {}});
    const ExprId derivative = differentiate.derivative_or_zero(definition.body);
    const ExprNode node = tree[derivative];
    question.assumptions.push_back({derivative, zero_of_rank(tree, node.span, node.rank, node.axes)});
  }
  if (budget.exceeded) return false;
  question.claim = impossible_in(tree, {definition.body, definition.body});
  const std::vector<Equation> place = somewhere(tree, names, {question.claim}, By::space);
  question.assumptions.insert(question.assumptions.end(), place.begin(), place.end());
  question.tree = &tree;
  return assumptions_contradict(question, limits_of_contradictions);
}

}  // namespace

bool last_assumption_contradicts(ExprTree& tree, const Names& names) {
  const Equation last = names.scope.assumptions.back().equation;
  if (last.relation != Relation::equal) return false;
  Prepared prepared = prepare(tree, names, impossible_in(tree, last), 1);
  if (!may_contradict(prepared)) return false;
  auto& assumptions = prepared.question.assumptions;
  std::vector<Equation> running;
  for (const NamedAssumption* each : prepared.assumptions) {
    if (each != nullptr && runs_with_time(tree, names, each->equation)) running.push_back(each->equation);
  }
  const std::vector<Equation> moment = somewhere(tree, names, running, By::time);
  assumptions.insert(assumptions.end(), moment.begin(), moment.end());
  prepared.question.tree = &tree;
  return assumptions_contradict(prepared.question, limits_of_contradictions);
}

bool definition_contradicts(ExprTree& tree, const Names& names, const Definition& definition) {
  if (is_declared_constant(names.scope, definition.symbol) && changes_with_place(tree, names, definition))
    return true;
  Names instead = names;
  forget_definition(instead.scope, definition.symbol);
  assume(instead.scope, {as_equation(tree, definition), {}, 0});
  return last_assumption_contradicts(tree, instead);
}

Directives withdraw_constants_of_last(const ExprTree& tree, Names& names) {
  Directives withdrawn;
  for (const SymbolId base : bases_of(tree, names.scope.assumptions.back().equation))
    withdrawn.merge(withdraw_constant(names.scope, base));
  return withdrawn;
}

std::optional<SymbolId> small_of_other_order(ExprTree& tree, const Names& names, const Equation& equation,
                                             DecisionCache* cache) {
  if (equation.relation != Relation::equal) return std::nullopt;
  std::set<SymbolId> small;
  for (const SmallQuantity& each : names.scope.small) {
    if (tree[each.quantity].slot_count == 0) small.insert(base_of(tree.symbols, tree[each.quantity].symbol));
  }
  const std::set<SymbolId> bases = bases_of(tree, equation);
  for (const SymbolId own : bases) {
    const auto is_number = [&](SymbolId each) {
      return tree.symbols[each].rank == 0 && !tree.symbols[each].per_particle;
    };
    if (!small.contains(own) || !is_number(own) || !vanishes(tree, names, own, 1, cache)) continue;
    const bool by_another = std::ranges::any_of(bases, [&](SymbolId other) {
      return !small.contains(other) && is_number(other) && vanishes(tree, names, other, 0, cache);
    });
    if (by_another) return own;
  }
  return std::nullopt;
}

}  // namespace rigor
