// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/reading/typed.h"

namespace rigor {

void merge_letters(Typed& into, const Typed& part) {
  merge_free(into.free, part.free);
  merge_free(into.particles, part.particles);
  merge_free(into.bound, part.bound);
}

namespace {

/// That of the first operand of this rank that has one; else a vector beside a matrix is a column.
Layout layout_of(const std::vector<Typed>& operands, int rank) {
  Layout found = Layout::none;
  if (rank == 0) return found;
  for (const Typed& operand : operands) {
    if (operand.layout == Layout::none) continue;
    if (operand.rank == rank) return operand.layout;
    found = rank == 1 ? Layout::column : Layout::matrix;
  }
  return found;
}

}  // namespace

Typed apply_op(ExprTree& tree, Op op, Span span, int rank, const std::vector<Typed>& operands, int exponent) {
  Typed typed{.rank = rank, .layout = layout_of(operands, rank)};
  std::vector<ExprId> children;
  for (const Typed& operand : operands) {
    children.push_back(operand.id);
    merge_letters(typed, operand);
  }
  typed.id = tree.add({.op = op, .rank = static_cast<std::uint8_t>(rank), .span = span, .exponent = exponent},
                      children);
  return typed;
}

Typed tuple_of(ExprTree& tree, Space space, Span span, const std::vector<Typed>& entries) {
  Typed typed{.rank = entries.front().rank + 1};
  std::vector<ExprId> children;
  for (const Typed& entry : entries) {
    children.push_back(entry.id);
    merge_letters(typed, entry);
  }
  typed.id = tree.add({.op = Op::tuple,
                       .rank = static_cast<std::uint8_t>(typed.rank),
                       .span = span,
                       .axes = AxisSpaces::of(space, 1)},
                      children);
  return typed;
}

ExprId sum_of(ExprTree& tree, const std::vector<ExprId>& terms, int rank, Span span) {
  return tree.add({.op = Op::add, .rank = static_cast<std::uint8_t>(rank), .span = span}, terms);
}

bool is_literal_zero(const ExprTree& tree, const Typed& typed) {
  return typed.rank == 0 && tree.is_zero_literal(typed.id);
}

}  // namespace rigor
