// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/polynomial/factor_node.h"

#include <array>
#include <cstdlib>

#include "derive/polynomial/nodes.h"

namespace rigor {
namespace {

using Kind = IndexFactor::Kind;

ExprId node_of(ExprTree& tree, Op op, ExprId child, Function function = {}) {
  const std::array children{child};
  return tree.add({.op = op, .function = function}, children);
}

ExprId root_node(ExprTree& tree, const IndexFactor& factor, int exponent) {
  if (const auto vector = vector_of_length(tree, factor))
    return power_node(tree, node_of(tree, Op::length, *vector), exponent);
  const ExprId argument = expression_of(tree, *factor.argument);
  if (exponent % 2 == 0) return power_node(tree, argument, exponent / 2);
  return power_node(tree, node_of(tree, Op::root, argument), exponent);
}

ExprId table_node(ExprTree& tree, const IndexFactor& factor) {
  const std::vector<ExprId> values(tree.children(factor.table).begin(), tree.children(factor.table).end());
  return tree.add_table({}, values, factor.slots, Table(tree.table(factor.table)));
}

}  // namespace

std::optional<ExprId> vector_of_length(ExprTree& tree, const IndexFactor& root) {
  if (root.kind != Kind::root || root.argument->terms.size() != 1) return std::nullopt;
  const IndexMonomial& square = root.argument->terms[0];
  if (square.coefficient != SmallRational(1) || square.indices.size() != 1 || !square.particles.empty() ||
      square.factors.size() != 2)
    return std::nullopt;
  const IndexFactor& a = square.factors[0];
  const IndexFactor& b = square.factors[1];
  const bool same = a.kind == Kind::component && b.kind == Kind::component && a.symbol == b.symbol &&
                    a.particle == b.particle && a.exponent == 1 && b.exponent == 1 && a.slots.size() == 1;
  if (!same || !speaks_of(a, square.indices[0]) || !speaks_of(b, square.indices[0])) return std::nullopt;
  return symbol_node(tree, a.symbol, a.particle, {});
}

ExprId factor_node(ExprTree& tree, const IndexFactor& factor) {
  const int exponent = std::abs(factor.exponent);
  switch (factor.kind) {
    case Kind::delta:
      return tree.add({.op = Op::delta}, {}, factor.slots);
    case Kind::epsilon:
      return tree.add({.op = Op::epsilon}, {}, factor.slots);
    case Kind::component:
      return power_node(tree, symbol_node(tree, factor.symbol, factor.particle, factor.slots), exponent);
    case Kind::root:
      return root_node(tree, factor, exponent);
    case Kind::sum:
      return power_node(tree, expression_of(tree, *factor.argument), exponent);
    case Kind::function:
      return power_node(tree,
                        node_of(tree, Op::function, expression_of(tree, *factor.argument), factor.function),
                        exponent);
    case Kind::table:
      return power_node(tree, table_node(tree, factor), exponent);
  }
  return number_node(tree, 1);
}

}  // namespace rigor
