// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/lint/lint_readings.h"

#include <set>

namespace rigor {
namespace {

ReadAs read_as(const ExprNode& node) {
  if (node.op == Op::length) return ReadAs::length;
  if (node.rank == 0) return ReadAs::number;
  return node.rank == 1 ? ReadAs::vector : ReadAs::tensor;
}

}  // namespace

std::map<Extent, SymbolReading> symbol_readings(const LintInput& input) {
  const ExprTree& tree = input.tree;
  std::map<Extent, SymbolReading> readings;
  std::set<Extent> composed;
  for (const StatedEquation& stated : input.stated) {
    for (const ExprId id : nodes_below(tree, {stated.left, stated.right})) {
      const bool length = tree[id].op == Op::length && tree[tree.children(id)[0]].op == Op::symbol;
      const ExprNode& node = length ? tree[tree.children(id)[0]] : tree[id];
      const Extent extent = extent_of(tree[id].span);
      if (node.op != Op::symbol || node.slot_count > 0) {
        composed.insert(extent);
        continue;
      }
      SymbolReading reading{read_as(tree[id]), node.symbol, tree.symbols[node.symbol].name, tree[id].span};
      const auto [known, fresh] = readings.try_emplace(extent, reading);
      if (!fresh && length) known->second = std::move(reading);  // the vector alone is part of the length
    }
  }
  for (const Extent& extent : composed) {
    const auto found = readings.find(extent);
    if (found != readings.end() && found->second.meaning != ReadAs::length) readings.erase(found);
  }
  return readings;
}

}  // namespace rigor
