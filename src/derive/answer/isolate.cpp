// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/answer/isolate.h"

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "derive/polynomial/nodes.h"
#include "expr/calculus/differentiate.h"

namespace rigor {
namespace {

class Isolating {
 public:
  Isolating(ExprTree& tree, const Equation& claim, SymbolId hole)
      : tree_(tree), claim_(claim), hole_(hole), value_(claim.left), at_(claim.right) {}

  Isolation run() {
    while (tree_[at_].op != Op::symbol) {
      if (auto why = why_nonlinear(tree_[at_].op)) return {.obstacle = std::move(*why)};
      if (occurrences_of(tree_, at_, hole_) > 1) return by_two_values("it occurs more than once");
      if (!undo()) return by_two_values(std::move(obstacle_));
    }
    return {.value = value_, .squared = squared_};
  }

 private:
  Span span() const { return tree_[at_].span; }

  ExprId make(Op op, std::vector<ExprId> children, int exponent = 0) {
    int rank = 0;
    switch (op) {
      case Op::add:
      case Op::negate:
      case Op::divide:
        rank = tree_[children[0]].rank;
        break;
      case Op::multiply:
        for (const ExprId child : children) rank += tree_[child].rank;
        break;
      default:
        break;
    }
    return tree_.add(
        {.op = op, .rank = static_cast<std::uint8_t>(rank), .span = span(), .exponent = exponent}, children);
  }

  ExprId minus(ExprId a, ExprId b) {
    if (is_zero(b)) return a;
    const ExprId negative = make(Op::negate, {b});
    return is_zero(a) ? negative : make(Op::add, {a, negative});
  }

  bool is_zero(ExprId id) const {
    if (tree_[id].op == Op::tuple) {
      return std::ranges::all_of(tree_.children(id), [&](ExprId entry) { return is_zero(entry); });
    }
    return tree_.is_zero_literal(id);
  }

  /// One operation; false and the reason where it cannot be undone.
  bool undo() {
    const ExprNode node = tree_[at_];
    const std::vector<ExprId> children(tree_.children(at_).begin(), tree_.children(at_).end());
    std::size_t own = 0;
    while (own + 1 < children.size() && occurrences_of(tree_, children[own], hole_) == 0) ++own;
    std::vector<ExprId> others = children;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(own));
    switch (node.op) {
      case Op::add:
        for (const ExprId other : others) value_ = minus(value_, other);
        break;
      case Op::negate:
        value_ = tree_[value_].op == Op::negate ? tree_.children(value_)[0] : make(Op::negate, {value_});
        break;
      case Op::multiply:
        if (!divide_by(others, tree_[children[own]].rank)) return false;
        break;
      case Op::divide:
        if (own == 0) {
          value_ = make(Op::multiply, {children[1], value_});
        } else if (node.rank == 0) {
          value_ = make(Op::divide, {children[0], value_});
        } else {
          obstacle_ = "it divides a vector";
          return false;
        }
        break;
      case Op::root:
        value_ = make(Op::power, {value_}, 2);
        squared_ = true;
        break;
      default:
        obstacle_ = why_not(node.op);
        return false;
    }
    at_ = children[own];
    return true;
  }

  static std::optional<std::string> why_nonlinear(Op op) {
    switch (op) {
      case Op::power:
        return "the equation is not linear in it: it is in a power";
      case Op::length:
      case Op::absolute:
        return "the equation is not linear in it: it is between bars";
      case Op::function:
        return "the equation is not linear in it: it is in a function";
      default:
        return std::nullopt;
    }
  }

  static std::string why_not(Op op) {
    switch (op) {
      case Op::dot:
      case Op::cross:
      case Op::index_sum:
        return "it is multiplied and summed over";
      case Op::particle_sum:
        return "it is inside a sum over particles";
      default:
        return "the operation around it is not undone";
    }
  }

  bool divide_by(const std::vector<ExprId>& others, int own_rank) {
    const ExprId factor = others.size() == 1 ? others[0] : make(Op::multiply, others);
    const int rank = tree_[factor].rank;
    note_own_letters();
    const std::vector<IndexId> letters = leftover(factor);
    if (rank == 0 && letters.empty()) {
      value_ = make(Op::divide, {value_, factor});
      return true;
    }
    if (rank == 1 && own_rank == 0 && letters.empty()) {
      value_ = make(Op::divide, {make(Op::dot, {value_, factor}), make(Op::dot, {factor, factor})});
      return true;
    }
    if (rank > 0) {
      obstacle_ = "it is multiplied by a tensor, or by a vector without a sign between them";
      return false;
    }
    ExprId above = make(Op::multiply, {value_, factor});
    ExprId below = make(Op::multiply, {factor, factor});
    for (const IndexId letter : letters) {
      above = sum_over(letter, above);
      below = sum_over(letter, below);
    }
    value_ = make(Op::divide, {above, below});
    return true;
  }

  ExprId sum_over(IndexId letter, ExprId body) {
    return tree_.add({.op = Op::index_sum, .span = span(), .index = letter}, std::span(&body, 1));
  }

  /// Is the hole only added, multiplied by what is free of it, and summed?
  bool is_linear(ExprId id) const {
    if (occurrences_of(tree_, id, hole_) == 0) return true;
    const ExprNode& node = tree_[id];
    const auto children = tree_.children(id);
    const auto speaks = [&](ExprId child) { return occurrences_of(tree_, child, hole_) > 0; };
    const auto with_hole = std::ranges::count_if(children, speaks);
    switch (node.op) {
      case Op::symbol:
        return true;
      case Op::divide:
        if (speaks(children[1])) return false;
        break;
      case Op::multiply:
      case Op::dot:
      case Op::cross:
        if (with_hole > 1) return false;
        break;
      case Op::add:
      case Op::negate:
      case Op::index_sum:
      case Op::particle_sum:
      case Op::component:
      case Op::tuple:
      case Op::table:
        break;
      default:
        return false;
    }
    return std::ranges::all_of(children, [&](ExprId child) { return is_linear(child); });
  }

  void note_letters_on(ExprId id, std::set<IndexId>& letters) const {
    for (const Slot& slot : tree_.slots(id)) {
      if (slot.axis == 0) letters.insert(slot.variable);
    }
  }

  /// The letters of the hole itself.
  void note_own_letters() {
    for (const ExprId id : nodes_below(tree_, {claim_.right})) {
      if (tree_[id].op == Op::symbol && tree_[id].symbol == hole_) note_letters_on(id, own_);
    }
  }

  /// The claim's free letters that are in an expression and not on the hole.
  std::vector<IndexId> leftover(ExprId root) const {
    std::set<IndexId> present;
    for (const ExprId id : nodes_below(tree_, {root})) note_letters_on(id, present);
    std::vector<IndexId> letters;
    for (const IndexId letter : claim_.indices) {
      if (present.contains(letter) && !own_.contains(letter)) letters.push_back(letter);
    }
    return letters;
  }

  /// A number x in f(x) = f(0) + (f(1) − f(0)) x.
  Isolation by_two_values(std::string obstacle) {
    const Symbol& symbol = tree_.symbols[hole_];
    const bool fits = symbol.rank == 0 && tree_[at_].rank == 0 && leftover(claim_.right).empty();
    if (!fits) return {.obstacle = std::move(obstacle)};
    if (!is_linear(at_)) return {.obstacle = "the equation is not linear in it"};
    const ExprId zero = with_symbol_as(tree_, at_, hole_, tree_.add_number(span(), "0"));
    const ExprId one = with_symbol_as(tree_, at_, hole_, tree_.add_number(span(), "1"));
    return {.value = make(Op::divide, {minus(value_, zero), minus(one, zero)}), .squared = squared_};
  }

  ExprTree& tree_;
  const Equation& claim_;
  SymbolId hole_;
  ExprId value_;
  ExprId at_;
  std::set<IndexId> own_;
  std::string obstacle_;
  bool squared_ = false;
};

}  // namespace

int occurrences_of(const ExprTree& tree, ExprId root, SymbolId symbol) {
  if (tree[root].op == Op::symbol) return tree[root].symbol == symbol ? 1 : 0;
  int count = 0;
  for (const ExprId child : tree.children(root)) {
    if (count < 2) count += occurrences_of(tree, child, symbol);
  }
  return std::min(count, 2);
}

ExprId with_symbol_as(ExprTree& tree, ExprId root, SymbolId symbol, ExprId value) {
  return replaced(tree, root, [&](ExprId each) -> std::optional<ExprId> {
    return tree[each].symbol == symbol ? std::optional(value) : std::nullopt;
  });
}

Isolation isolated(ExprTree& tree, const Equation& claim, SymbolId hole) {
  return Isolating(tree, claim, hole).run();
}

}  // namespace rigor
