// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/scope/decomposition.h"

#include <algorithm>
#include <span>

#include "base/among.h"
#include "expr/calculus/differentiate.h"

namespace rigor {
namespace {

/// `S_{ij}` where the letters are those of the whole, in their order.
bool is_bare_part(const ExprTree& tree, const Definition& whole, ExprId term) {
  const ExprNode& node = tree[term];
  const auto slots = tree.slots(term);
  return node.op == Op::symbol && node.particle == whole.particle && !tree.symbols[node.symbol].derivation &&
         std::ranges::equal(slots, whole.indices, [](const Slot& slot, IndexId letter) {
           return slot.axis == 0 && slot.variable == letter;
         });
}

/// A sum of bare parts, each another one.
std::optional<Decomposition> sum_of_parts(const ExprTree& tree, const Definition& whole,
                                          const Origin& origin) {
  if (tree[whole.body].op != Op::add) return std::nullopt;
  Decomposition apart{whole, origin, {}};
  for (const ExprId term : tree.children(whole.body)) {
    const bool again =
        std::ranges::any_of(apart.parts, [&](ExprId part) { return tree[part].symbol == tree[term].symbol; });
    if (again || !is_bare_part(tree, whole, term)) return std::nullopt;
    apart.parts.push_back(term);
  }
  return apart;
}

/// What the equations of one section say of their left sides, whether they define them or are assumed.
std::vector<Decomposition> sums_stated(const ExprTree& tree, const Names& names, std::size_t place) {
  std::vector<Decomposition> sums;
  const auto add = [&](const Definition& whole, const Origin& origin) {
    if (origin.directive || origin.conditional || origin.place != place || whole.by_square) return;
    if (auto sum = sum_of_parts(tree, whole, origin)) sums.push_back(*std::move(sum));
  };
  for (const NamedDefinition& named : names.scope.definitions) add(named.definition, named.origin);
  for (const NamedAssumption& assumption : names.scope.assumptions) {
    const Equation& said = assumption.equation;
    const ExprNode& left = tree[said.left];
    if (said.relation != Relation::equal || left.op != Op::symbol) continue;
    Definition whole{left.symbol, {}, left.particle, said.right};
    for (const Slot& slot : tree.slots(said.left)) whole.indices.push_back(slot.variable);
    add(whole, assumption.origin);
  }
  return sums;
}

ExprId difference(ExprTree& tree, ExprId whole, const std::vector<ExprId>& parts) {
  const ExprNode like = tree[whole];
  std::vector<ExprId> terms{whole};
  for (const ExprId part : parts)
    terms.push_back(tree.add({.op = Op::negate, .rank = like.rank, .span = like.span}, std::span(&part, 1)));
  return tree.add({.op = Op::add, .rank = like.rank, .span = like.span}, terms);
}

}  // namespace

std::optional<Decomposition> decomposition(const ExprTree& tree, const Names& names, ExprId part,
                                           ExprId made_of, std::size_t place) {
  if (tree[part].op != Op::symbol || definition_of(names.scope, tree[part].symbol) != nullptr)
    return std::nullopt;
  const std::vector<SymbolId> inside = symbols_in(tree, made_of);
  const auto is_inside = [&](SymbolId symbol) { return is_one_of(symbol, inside); };
  for (Decomposition& sum : sums_stated(tree, names, place)) {
    const auto is_part = [&](ExprId term) { return tree[term].symbol == tree[part].symbol; };
    const bool fits =
        is_inside(sum.whole.symbol) && std::ranges::any_of(sum.parts, is_part) &&
        std::ranges::none_of(sum.parts, [&](ExprId term) { return is_inside(tree[term].symbol); });
    if (fits) return std::move(sum);
  }
  return std::nullopt;
}

void take_apart(ExprTree& tree, Names& names, const Decomposition& apart, SymbolId part) {
  const Definition& whole = apart.whole;
  const Equation sum = as_equation(tree, whole);
  forget_definition(names.scope, whole.symbol);
  names.scope.assumptions.erase_if(
      [&](const NamedAssumption& said) { return said.equation.right == whole.body; });
  std::vector<ExprId> known;
  std::vector<ExprId> open;
  for (const ExprId term : apart.parts) {
    const SymbolId symbol = tree[term].symbol;
    (symbol == part || definition_of(names.scope, symbol) != nullptr ? known : open).push_back(term);
  }
  if (open.size() != 1) return assume(names.scope, {sum, apart.origin, 0});
  Definition last = whole;
  last.symbol = tree[open.front()].symbol;
  last.body = difference(tree, sum.left, known);
  define(names.scope, {last, apart.origin, 0});
}

}  // namespace rigor
