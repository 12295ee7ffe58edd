// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/law/value_conditions.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "base/among.h"
#include "expr/tree/same_expression.h"

namespace rigor {
namespace {

std::optional<ValueCondition> condition_in(const ExprTree& tree, const Names& names, const PageLaw& law,
                                           SymbolId unknown) {
  std::optional<ValueCondition> found;
  if (law.equation.relation != Relation::equal) return std::nullopt;
  for (const ExprId side : {law.equation.left, law.equation.right}) {
    for (const SymbolId symbol : symbols_in(tree, side)) {
      if (base_of(tree.symbols, symbol) == unknown) return std::nullopt;  // `y = y(0)e^{kx}` is a solution
      const auto value = names.symbols.function_values.find(symbol);
      if (value == nullptr) continue;
      const Symbol& function = tree.symbols[value->second.of];
      if (base_of(tree.symbols, value->second.of) != unknown || value->second.at.size() != 1 || found)
        return std::nullopt;
      found = ValueCondition{&law, value->second.at[0],
                             function.derivation ? static_cast<int>(function.derivation->by.size()) : 0};
    }
  }
  return found;
}

/// Nothing but sums, products and whole powers stands over the unknown and its derivatives.
bool is_polynomial_in(const ExprTree& tree, ExprId id, SymbolId unknown) {
  const auto has_it = [&](ExprId part) {
    return std::ranges::any_of(symbols_in(tree, part),
                               [&](SymbolId each) { return base_of(tree.symbols, each) == unknown; });
  };
  if (!has_it(id)) return true;
  const ExprNode& node = tree[id];
  const auto children = tree.children(id);
  switch (node.op) {
    case Op::symbol:
      return true;
    case Op::divide:
      return !has_it(children[1]) && is_polynomial_in(tree, children[0], unknown);
    case Op::power:
      if (node.exponent < 0) return false;
      [[fallthrough]];
    case Op::add:
    case Op::negate:
    case Op::multiply:
      return std::ranges::all_of(children,
                                 [&](ExprId child) { return is_polynomial_in(tree, child, unknown); });
    default:
      return false;
  }
}

class Shape {
 public:
  Shape(const ExprTree& tree, const Names& names, const DifferentialEquation& equation)
      : tree_(tree), names_(names), equation_(equation) {}

  /// `\mu u'' = -G`.
  bool has_only_the_highest() const {
    return std::ranges::all_of(sides(), [this](ExprId side) {
      return std::ranges::all_of(symbols_in(tree_, side),
                                 [this](SymbolId each) { return !is_unknown(each) || is_highest(each); });
    });
  }

  /// Not `t\dot x = x`, which all lines through the origin obey.
  bool leads_with_a_constant() const {
    return std::ranges::all_of(sides(), [this](ExprId side) {
      return std::ranges::all_of(nodes_below(tree_, {side}), [this](ExprId id) {
        const Op op = tree_[id].op;
        if (op != Op::multiply && op != Op::divide && op != Op::power) return true;
        const auto children = tree_.children(id);
        const auto leads = [this](ExprId child) { return has(child, &Shape::is_highest); };
        if (std::ranges::none_of(children, leads)) return true;
        return op != Op::power && std::ranges::all_of(children, [&](ExprId child) {
                 return leads(child) ? tree_[child].op != Op::power : !has(child, &Shape::changes);
               });
      });
    });
  }

 private:
  std::array<ExprId, 2> sides() const { return {equation_.equation.left, equation_.equation.right}; }
  bool is_unknown(SymbolId symbol) const { return base_of(tree_.symbols, symbol) == equation_.unknown; }
  bool is_highest(SymbolId symbol) const {
    const auto& derivation = tree_.symbols[symbol].derivation;
    return is_unknown(symbol) && derivation && static_cast<int>(derivation->by.size()) == equation_.order;
  }
  bool changes(SymbolId symbol) const {
    return is_unknown(symbol) ||
           change(names_, tree_, symbol, equation_.by).dependence.kind == Dependence::Kind::variable;
  }
  bool has(ExprId id, bool (Shape::*what)(SymbolId) const) const {
    return std::ranges::any_of(symbols_in(tree_, id), [&](SymbolId each) { return (this->*what)(each); });
  }

  const ExprTree& tree_;
  const Names& names_;
  const DifferentialEquation& equation_;
};

}  // namespace

std::vector<ValueCondition> conditions_on(const ExprTree& tree, const Names& names, const Laws& laws,
                                          SymbolId unknown) {
  std::vector<ValueCondition> conditions;
  for (const PageLaw* law : laws) {
    if (const auto condition = condition_in(tree, names, *law, unknown)) conditions.push_back(*condition);
  }
  return conditions;
}

bool leave_one_solution(const ExprTree& tree, const Names& names, const DifferentialEquation& equation,
                        const std::vector<ValueCondition>& conditions) {
  const auto& [said, unknown, by, axis, order] = equation;
  const Shape shape(tree, names, equation);
  if (!is_polynomial_in(tree, said.left, unknown) || !is_polynomial_in(tree, said.right, unknown) ||
      !shape.leads_with_a_constant())
    return false;
  const bool starts = std::ranges::any_of(conditions, [&](const ValueCondition& first) {
    std::set<int> orders;
    for (const ValueCondition& each : conditions) {
      if (each.order < equation.order && same_expression(tree, each.at, tree, first.at))
        orders.insert(each.order);
    }
    return static_cast<int>(orders.size()) == equation.order;
  });
  if (starts) return true;
  if (order != 2 || !shape.has_only_the_highest()) return false;
  return std::ranges::any_of(conditions, [&](const ValueCondition& one) {
    return one.order == 0 && std::ranges::any_of(conditions, [&](const ValueCondition& other) {
             return other.order < 2 && !same_expression(tree, one.at, tree, other.at);
           });
  });
}

}  // namespace rigor
