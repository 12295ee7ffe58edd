// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/notation/in_components.h"

#include <array>
#include <vector>

#include "derive/polynomial/nodes.h"
#include "expr/calculus/differentiate.h"

namespace rigor {
namespace {

/// Recursion: as deep as the tree, which the parser bounds.
class Components {
 public:
  Components(ExprTree& tree, WrittenOut& what) : tree_(tree), what_(what) {}

  ExprId write(ExprId id, std::vector<Slot> slots) {
    const ExprNode node = tree_[id];
    switch (node.op) {
      case Op::symbol:
        return slots.empty() ? id : component_of(tree_, id, slots);
      case Op::basis:
        what_.insert("components of a unit vector");
        return tree_.add({.op = Op::delta}, {}, std::array{tree_.slots(id)[0], slots[0]});
      case Op::multiply:
        return product(id, slots);
      case Op::divide:
        return quotient_node(tree_, write(child(id), slots), write(child(id, 1), {}));
      case Op::power:
        return power(id);
      case Op::dot:
        return dot(id, slots);
      case Op::cross:
        return cross(id, slots[0]);
      case Op::component: {
        const std::vector<Slot> own(tree_.slots(id).begin(), tree_.slots(id).end());
        return write(child(id), own);
      }
      case Op::tuple:
        return tuple(id, std::move(slots));
      case Op::determinant:
      case Op::table:
      case Op::length:
        return slots.empty() ? id : component_of(tree_, id, slots);
      default:
        return each_child(id, slots);
    }
  }

 private:
  [[nodiscard]] ExprId child(ExprId id, std::size_t which = 0) const { return tree_.children(id)[which]; }
  Slot fresh() { return {0, tree_.add_index("")}; }

  /// What acts on each component alone.
  ExprId each_child(ExprId id, const std::vector<Slot>& slots) {
    ExprNode node = tree_[id];
    const std::vector<ExprId> before(tree_.children(id).begin(), tree_.children(id).end());
    std::vector<ExprId> after;
    for (const ExprId each : before) after.push_back(write(each, slots));
    if (after == before) return id;
    node.rank = 0;
    return tree_.add(node, after);
  }

  ExprId product(ExprId id, const std::vector<Slot>& slots) {
    std::vector<ExprId> factors;
    auto from = slots.begin();
    for (std::size_t k = 0; k < tree_[id].count; ++k) {
      const ExprId factor = child(id, k);
      const auto to = from + tree_[factor].rank;
      factors.push_back(write(factor, {from, to}));
      from = to;
    }
    return product_node(tree_, factors);
  }

  ExprId power(ExprId id) {
    const ExprNode node = tree_[id];
    const ExprId base = child(id);
    if (tree_[base].op == Op::length && node.exponent > 0 && node.exponent % 2 == 0) {
      what_.insert("the square of a length");
      return power_node(tree_, contracted(child(base), child(base), {}, {}), node.exponent / 2);
    }
    return power_node(tree_, write(base, {}), node.exponent);
  }

  /// Σ_k a_k b_k after and before other slots.
  ExprId contracted(ExprId a, ExprId b, std::vector<Slot> left, const std::vector<Slot>& right) {
    const Slot index = fresh();
    left.push_back(index);
    std::vector<Slot> behind{index};
    behind.insert(behind.end(), right.begin(), right.end());
    const ExprId first = write(a, left);
    return index_sum_node(tree_, index.variable, product_node(tree_, {first, write(b, behind)}));
  }

  ExprId dot(ExprId id, const std::vector<Slot>& slots) {
    what_.insert("definition of ·");
    const auto split = slots.begin() + (tree_[child(id)].rank - 1);
    return contracted(child(id), child(id, 1), {slots.begin(), split}, {split, slots.end()});
  }

  ExprId cross(ExprId id, const Slot& slot) {
    what_.insert("definition of ×");
    const Slot j = fresh();
    const Slot k = fresh();
    const ExprId epsilon = tree_.add({.op = Op::epsilon}, {}, std::array{slot, j, k});
    const ExprId first = write(child(id), {j});
    const ExprId body = product_node(tree_, {epsilon, first, write(child(id, 1), {k})});
    return index_sum_node(tree_, j.variable, index_sum_node(tree_, k.variable, body));
  }

  [[nodiscard]] bool is_identity(ExprId id) const {
    for (std::size_t row = 0; row < 3; ++row) {
      if (tree_[child(id, row)].op != Op::tuple) return false;
      for (std::size_t column = 0; column < 3; ++column) {
        const ExprId entry = child(child(id, row), column);
        const bool fits = tree_[entry].op == Op::number && tree_.digits(entry) == (row == column ? "1" : "0");
        if (!fits) return false;
      }
    }
    return true;
  }

  ExprId tuple(ExprId id, std::vector<Slot> slots) {
    if (slots.size() == 2 && is_identity(id)) return tree_.add({.op = Op::delta}, {}, slots);
    if (slots[0].axis == 0) return component_of(tree_, id, slots);
    const ExprId entry = child(id, slots[0].axis - 1u);
    slots.erase(slots.begin());
    return write(entry, std::move(slots));
  }

  ExprTree& tree_;
  WrittenOut& what_;
};

}  // namespace

ExprId in_components(ExprTree& tree, ExprId id, std::span<const Slot> slots, WrittenOut& what) {
  return Components(tree, what).write(id, {slots.begin(), slots.end()});
}

}  // namespace rigor
