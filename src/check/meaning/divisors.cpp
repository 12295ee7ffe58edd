// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/meaning/divisors.h"

#include <algorithm>
#include <set>

namespace rigor {
namespace {

void add_factors(const ExprTree& tree, ExprId divisor, std::set<SymbolId>& found) {
  std::vector<ExprId> pending{divisor};
  while (!pending.empty()) {
    const ExprId id = pending.back();
    pending.pop_back();
    const ExprNode& node = tree[id];
    const bool of_factors =
        node.op == Op::multiply || node.op == Op::negate || (node.op == Op::power && node.exponent > 0);
    if (of_factors) {
      const auto children = tree.children(id);
      pending.insert(pending.end(), children.begin(), children.end());
    } else if (node.op == Op::symbol && node.slot_count == 0 && tree.symbols[node.symbol].rank == 0 &&
               !tree.symbols[node.symbol].per_particle) {
      found.insert(node.symbol);
    }
  }
}

void add_divisors(const ExprTree& tree, ExprId root, std::set<SymbolId>& found) {
  for (const ExprId id : nodes_below(tree, {root})) {
    if (tree[id].op == Op::divide) add_factors(tree, tree.children(id)[1], found);
  }
}

}  // namespace

std::vector<SymbolId> divisors_of_sample(const ExprTree& tree, const Names& names, const Sample& sample) {
  const auto is_zero = [](const SampleValue& value) {
    return value.components.size() == 1 && value.components[0] == "0";
  };
  if (std::ranges::none_of(sample.values, is_zero)) return {};
  std::set<SymbolId> divisors;
  for (const NamedDefinition& each : names.scope.definitions)
    add_divisors(tree, each.definition.body, divisors);
  for (const NamedAssumption& each : names.scope.assumptions) {
    add_divisors(tree, each.equation.left, divisors);
    add_divisors(tree, each.equation.right, divisors);
  }
  std::vector<SymbolId> found;
  bool any_zero = false;
  for (const SampleValue& value : sample.values) {
    if (!divisors.contains(value.symbol)) continue;
    found.push_back(value.symbol);
    any_zero = any_zero || is_zero(value);
  }
  return any_zero ? found : std::vector<SymbolId>{};
}

}  // namespace rigor
