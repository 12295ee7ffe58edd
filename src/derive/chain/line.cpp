// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/chain/line.h"

#include <algorithm>

#include "derive/chain/shape.h"
#include "derive/polynomial/collected.h"
#include "derive/polynomial/nodes.h"

namespace rigor {
namespace {

/// Each three in a row as one of a rank more.
std::vector<ExprId> tuples_of(ExprTree& tree, const std::vector<ExprId>& entries) {
  std::vector<ExprId> tuples;
  for (std::size_t k = 0; k < entries.size(); k += 3) {
    const auto rank = static_cast<std::uint8_t>(tree[entries[k]].rank + 1);
    tuples.push_back(tree.add({.op = Op::tuple, .rank = rank}, std::span(entries).subspan(k, 3)));
  }
  return tuples;
}

}  // namespace

void describe(ExprTree& tree, Line& line, const std::vector<IndexId>& open) {
  std::vector<Slot> slots;
  for (const IndexId letter : open) slots.push_back({0, letter});
  line.shape.clear();
  line.terms.clear();
  for (const ExprId part : line.parts) {
    line.shape += shape_of(tree, part) + ';';
    const bool fits = tree[part].rank == slots.size();
    const auto polynomial = fits ? polynomial_of(tree, part, slots) : std::nullopt;
    if (!polynomial) {
      line.terms.clear();
      return;
    }
    line.terms += text_of_terms(tree.symbols, *polynomial) + ';';
  }
}

bool contains(const ExprTree& tree, ExprId root, Op op) {
  return std::ranges::any_of(nodes_below(tree, {root}), [&](ExprId id) { return tree[id].op == op; });
}

bool meets(const Line& a, const Line& b) {
  if (a.parts.size() != b.parts.size() || a.terms.empty() || a.terms != b.terms) return false;
  return a.shape == b.shape || (a.flat && b.flat);
}

ExprId as_expression(ExprTree& tree, const Line& line, const std::vector<IndexId>& free) {
  if (line.parts.size() == 1) return line.parts[0];
  std::size_t cases = 1;
  std::vector<Slot> slots;
  for (const IndexId letter : free) {
    slots.push_back({0, letter});
    cases *= 3;
  }
  std::vector<ExprId> values = line.parts;
  while (values.size() > cases) values = tuples_of(tree, values);
  if (free.empty()) return values[0];
  Table table;
  for (std::size_t k = 0; k < cases; ++k) table.entry.push_back(static_cast<std::uint8_t>(k));
  return tree.add_table({}, values, slots, std::move(table));
}

}  // namespace rigor
