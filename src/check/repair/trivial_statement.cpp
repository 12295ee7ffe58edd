// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/repair/trivial_statement.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace rigor {
namespace {

bool is_zero_as_written(const ExprTree& tree, ExprId id) {
  const auto children = tree.children(id);
  const auto is_zero = [&](ExprId child) { return is_zero_as_written(tree, child); };
  switch (tree[id].op) {
    case Op::number:
      return tree.is_zero_literal(id);
    case Op::add:
    case Op::negate:
    case Op::tuple:
      return std::ranges::all_of(children, is_zero);
    case Op::multiply:
    case Op::dot:
    case Op::cross:
      return std::ranges::any_of(children, is_zero);
    case Op::divide:
    case Op::length:
    case Op::absolute:
    case Op::root:
      return is_zero(children[0]);
    case Op::power:
      return tree[id].exponent > 0 && is_zero(children[0]);
    default:
      return false;
  }
}

/// Two terms of the sum are the same but for their signs. Those of different commutators are not written:
/// `[A,[B,C]] + [B,[C,A]] + [C,[A,B]]`.
bool has_cancelling_terms_of_sum(const ExprTree& tree, ExprId side) {
  std::set<std::string> terms[2];
  std::vector<std::pair<ExprId, bool>> pending{{side, false}};
  while (!pending.empty()) {
    const auto [id, negative] = pending.back();
    pending.pop_back();
    const Op op = tree[id].op;
    const bool nested = op == Op::add && id != side && has_operators(tree, id);
    if (!nested && (op == Op::add || op == Op::negate)) {
      for (const ExprId child : tree.children(id))
        pending.emplace_back(child, negative != (op == Op::negate));
      continue;
    }
    const std::string term = dump(tree, id);
    if (terms[negative ? 0 : 1].contains(term)) return true;
    terms[negative ? 1 : 0].insert(term);
  }
  return false;
}

/// In the side itself, or in a sum within it: `\nabla(\phi - \phi)`.
bool has_cancelling_terms(const ExprTree& tree, ExprId side) {
  return std::ranges::any_of(nodes_below(tree, {side}), [&](ExprId id) {
    const bool inner = id != side && tree[id].op == Op::add && !has_operators(tree, id);
    return (inner || id == side) && has_cancelling_terms_of_sum(tree, id);
  });
}

class InOrder {
 public:
  explicit InOrder(const ExprTree& tree) : tree_(tree) {}

  /// As a product of powers in the order of their texts: `xyx` and `x^2y` are written alike.
  [[nodiscard]] std::string product(ExprId id) const {
    std::map<std::string, int> powers;
    bool negative = false;
    collect(id, 1, powers, negative);
    std::string text = negative ? "-" : "";
    for (const auto& [factor, power] : powers) {
      if (power != 0) text += fmt::format("{}^{} ", factor, power);
    }
    return text;
  }

 private:
  void collect(ExprId id, int power, std::map<std::string, int>& powers, bool& negative) const {
    const auto children = tree_.children(id);
    switch (tree_[id].op) {
      case Op::negate:
        negative = negative != (power % 2 != 0);
        return collect(children[0], power, powers, negative);
      case Op::multiply:
        for (const ExprId child : children) collect(child, power, powers, negative);
        return;
      case Op::divide:
        collect(children[0], power, powers, negative);
        return collect(children[1], -power, powers, negative);
      case Op::power:
        return collect(children[0], power * tree_[id].exponent, powers, negative);
      default:
        break;
    }
    if (!is_one(id)) powers[factor(id)] += power;
  }

  [[nodiscard]] bool is_one(ExprId id) const { return tree_[id].op == Op::number && tree_.digits(id) == "1"; }

  [[nodiscard]] std::string factor(ExprId id) const {
    const auto children = tree_.children(id);
    if (children.empty()) return dump(tree_, id);
    const ExprNode& node = tree_[id];
    std::vector<std::string> parts;
    for (const ExprId child : children) parts.push_back(product(child));
    if (node.op == Op::add || node.op == Op::dot) std::ranges::sort(parts);
    return fmt::format("({} {} {} {} {} {})", static_cast<int>(node.op), static_cast<int>(node.function),
                       node.payload, static_cast<std::uint32_t>(node.index),
                       static_cast<std::uint32_t>(node.particle), fmt::join(parts, " "));
  }

  const ExprTree& tree_;
};

}  // namespace

bool is_trivial_up_to_order(const ExprTree& tree, ExprId left, ExprId right) {
  if (is_trivial(tree, left, right)) return true;
  if (has_operators(tree, left) || has_operators(tree, right)) return false;
  const InOrder in_order(tree);
  return in_order.product(left) == in_order.product(right);
}

bool is_trivial(const ExprTree& tree, ExprId left, ExprId right) {
  return dump(tree, left) == dump(tree, right) || has_cancelling_terms(tree, left) ||
         has_cancelling_terms(tree, right) ||
         (is_zero_as_written(tree, left) && is_zero_as_written(tree, right));
}

}  // namespace rigor
