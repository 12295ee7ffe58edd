// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/polynomial/nodes.h"

#include <array>
#include <string>

#include "expr/calculus/differentiate.h"

namespace rigor {

ExprId with_children(ExprTree& tree, ExprId id, const ExprNode& node, const std::vector<ExprId>& children,
                     const std::vector<Slot>& slots) {
  if (node.op == Op::table) return tree.add_table(node.span, children, slots, Table(tree.table(id)));
  return tree.add(node, children, slots);
}

ExprId number_node(ExprTree& tree, std::int64_t value) {
  const ExprId digits = tree.add_number({}, std::to_string(value < 0 ? -value : value));
  return value < 0 ? negated_node(tree, digits) : digits;
}

ExprId rational_node(ExprTree& tree, SmallRational value) {
  const std::int64_t over = value.over();
  ExprId number = number_node(tree, over < 0 ? -over : over);
  if (value.under() != 1) number = quotient_node(tree, number, number_node(tree, value.under()));
  return over < 0 ? negated_node(tree, number) : number;
}

ExprId product_node(ExprTree& tree, const std::vector<ExprId>& factors) {
  std::vector<ExprId> kept;
  std::uint8_t rank = 0;
  for (const ExprId factor : factors) {
    const bool one = tree[factor].op == Op::number && tree.digits(factor) == "1";
    if (one) continue;
    rank = static_cast<std::uint8_t>(rank + tree[factor].rank);
    kept.push_back(factor);
  }
  if (kept.empty()) return number_node(tree, 1);
  if (kept.size() == 1) return kept[0];
  return tree.add({.op = Op::multiply, .rank = rank}, kept);
}

ExprId sum_node(ExprTree& tree, const std::vector<ExprId>& terms, int rank) {
  if (terms.empty()) return zero_of_rank(tree, {}, rank);
  if (terms.size() == 1) return terms[0];
  return tree.add({.op = Op::add, .rank = tree[terms[0]].rank}, terms);
}

ExprId negated_node(ExprTree& tree, ExprId id) {
  if (tree[id].op == Op::negate) return tree.children(id)[0];
  const std::array child{id};
  return tree.add({.op = Op::negate, .rank = tree[id].rank}, child);
}

ExprId power_node(ExprTree& tree, ExprId base, int exponent) {
  if (exponent == 1) return base;
  const std::array child{base};
  return tree.add({.op = Op::power, .exponent = exponent}, child);
}

ExprId quotient_node(ExprTree& tree, ExprId dividend, ExprId divisor) {
  const std::array children{dividend, divisor};
  return tree.add({.op = Op::divide, .rank = tree[dividend].rank}, children);
}

ExprId dot_node(ExprTree& tree, ExprId a, ExprId b) {
  const std::array children{a, b};
  const auto rank = static_cast<std::uint8_t>(tree[a].rank + tree[b].rank - 2);
  return tree.add({.op = Op::dot, .rank = rank}, children);
}

ExprId cross_node(ExprTree& tree, ExprId a, ExprId b) {
  const std::array children{a, b};
  return tree.add({.op = Op::cross, .rank = 1}, children);
}

ExprId index_sum_node(ExprTree& tree, IndexId index, ExprId body) {
  const std::array child{body};
  return tree.add({.op = Op::index_sum, .rank = tree[body].rank, .index = index}, child);
}

ExprId particle_sum_node(ExprTree& tree, ParticleId particle, ExprId body) {
  const std::array child{body};
  return tree.add({.op = Op::particle_sum, .rank = tree[body].rank, .particle = particle}, child);
}

ExprId symbol_node(ExprTree& tree, SymbolId symbol, ParticleId particle, const std::vector<Slot>& slots) {
  const auto rank = static_cast<std::uint8_t>(slots.empty() ? tree.symbols[symbol].rank : 0);
  return tree.add({.op = Op::symbol, .rank = rank, .symbol = symbol, .particle = particle}, {}, slots);
}

}  // namespace rigor
