// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/question/granted.h"

#include <algorithm>
#include <utility>

#include "check/question/running_letters.h"
#include "elaborate/name/function_value.h"

namespace rigor {
namespace {

bool says_what_a_letter_is(const ExprTree& tree, const Names& names, const Equation& equation) {
  const ExprNode& left = tree[equation.left];
  const bool of_each = equation.particles == std::vector{left.particle};  // `p_s = e^{-\beta E_s}/Z`
  const bool alone = equation.relation == Relation::equal && left.op == Op::symbol && left.slot_count == 0 &&
                     (left.particle == no_particle || of_each) && left.rank == tree[equation.right].rank;
  if (!alone || is_function_value(names, tree, left.symbol) || tree.symbols[left.symbol].derivation ||
      tree.is_zero_literal(equation.right))
    return false;
  if (definition_of(names.scope, left.symbol) != nullptr) return false;
  const std::vector<SymbolId> reached = symbols_reached(tree, names.scope, {equation.right});
  return std::ranges::none_of(reached,
                              [&](SymbolId each) { return base_of(tree.symbols, each) == left.symbol; });
}

}  // namespace

void take_for_granted(const ExprTree& tree, Names& names, const Equation& equation, Origin origin,
                      bool at_instant) {
  if (!at_instant && says_what_a_letter_is(tree, names, equation)) {
    const ExprNode& left = tree[equation.left];
    NamedDefinition named{{left.symbol, {}, left.particle, equation.right}, std::move(origin)};
    named.along = runs_along(names, tree, named.definition);
    define(names.scope, std::move(named));
  } else {
    assume(names.scope, {equation, std::move(origin), 0, at_instant});
  }
}

}  // namespace rigor
