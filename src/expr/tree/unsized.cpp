// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/tree/unsized.h"

namespace rigor {
namespace {

[[nodiscard]] UnsizedShape turned_shape(UnsizedShape shape) {
  if (shape == UnsizedShape::column) return UnsizedShape::row;
  return shape == UnsizedShape::row ? UnsizedShape::column : shape;
}

[[nodiscard]] UnsizedShape shape_of_product(UnsizedShape a, UnsizedShape b) {
  if (a == UnsizedShape::none || b == UnsizedShape::none) return UnsizedShape::none;
  if (a == UnsizedShape::number) return b;
  if (b == UnsizedShape::number) return a;
  const bool first_is_tall = a == UnsizedShape::column;  // one column: a row or nothing can follow
  const bool second_is_flat = b == UnsizedShape::row;
  if (first_is_tall != second_is_flat) return UnsizedShape::none;
  if (first_is_tall) return UnsizedShape::matrix;
  if (a == UnsizedShape::row) return b == UnsizedShape::column ? UnsizedShape::number : UnsizedShape::row;
  return b;
}

[[nodiscard]] UnsizedShape shape_of_sum(UnsizedShape a, UnsizedShape b) {
  if (a == b) return a;
  const bool unit = (a == UnsizedShape::number && b == UnsizedShape::matrix) ||
                    (a == UnsizedShape::matrix && b == UnsizedShape::number);
  return unit ? UnsizedShape::matrix : UnsizedShape::none;
}

}  // namespace

bool is_unsized(const ExprTree& tree, ExprId root) {
  bool any = false;
  for (const ExprId id : nodes_below(tree, {root})) {
    if (tree[id].op != Op::symbol || !tree.symbols[tree[id].symbol].noncommuting) continue;
    if (tree.symbols[tree[id].symbol].unsized == Unsized::none) return false;
    any = true;
  }
  return any;
}

UnsizedShape unsized_shape(const ExprTree& tree, ExprId root) {
  const ExprNode& node = tree[root];
  const auto children = tree.children(root);
  const auto of = [&](std::size_t k) { return unsized_shape(tree, children[k]); };
  switch (node.op) {
    case Op::symbol:
      if (tree.symbols[node.symbol].unsized == Unsized::none) return UnsizedShape::number;
      return tree.symbols[node.symbol].unsized == Unsized::column ? UnsizedShape::column
                                                                  : UnsizedShape::matrix;
    case Op::add: {
      UnsizedShape shape = of(0);
      for (std::size_t k = 1; k < children.size(); ++k) {
        if (!tree.is_zero_literal(children[k])) shape = shape_of_sum(shape, of(k));
      }
      return shape;
    }
    case Op::multiply: {
      UnsizedShape shape = of(0);
      for (std::size_t k = 1; k < children.size(); ++k) shape = shape_of_product(shape, of(k));
      return shape;
    }
    case Op::negate:
    case Op::divide:
      return of(0);
    case Op::power:
      return of(0) == UnsizedShape::matrix || of(0) == UnsizedShape::number ? of(0) : UnsizedShape::none;
    case Op::transpose:
    case Op::conjugate:
      return turned_shape(of(0));
    default:
      return UnsizedShape::number;
  }
}

}  // namespace rigor
