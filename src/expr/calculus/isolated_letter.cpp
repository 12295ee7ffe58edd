// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/calculus/isolated_letter.h"

#include <algorithm>
#include <array>
#include <utility>

#include "expr/calculus/integrate.h"

namespace rigor {
namespace {

std::size_t count_of(const ExprTree& tree, ExprId id, SymbolId letter) {
  const ExprNode& node = tree[id];
  std::size_t count = node.op == Op::symbol && node.symbol == letter ? 1 : 0;
  for (const ExprId child : tree.children(id)) count += count_of(tree, child, letter);
  return count;
}

/// Is the letter below it, in a derivative, an integral or an average as well?
bool hides(const ExprTree& tree, ExprId id, SymbolId letter) {
  return std::ranges::any_of(symbols_in(tree, id), [&](SymbolId each) {
    const Symbol& symbol = tree.symbols[each];
    return symbol.integral.has_value() ||
           (symbol.derivation.has_value() && base_of(tree.symbols, each) == letter);
  });
}

/// Takes off, one after the other, what stands around the letter.
class Isolating {
 public:
  Isolating(ExprTree& tree, SymbolId letter, ExprId value) : tree_(tree), letter_(letter), found_{value} {}

  std::optional<IsolatedLetter> from(ExprId side) {
    while (tree_[side].op != Op::symbol) {
      const auto inside = taken_off(side);
      if (!inside) return std::nullopt;
      side = *inside;
    }
    return std::move(found_);
  }

 private:
  std::optional<ExprId> taken_off(ExprId side) {
    const ExprNode node = tree_[side];
    const std::vector<ExprId> children(tree_.children(side).begin(), tree_.children(side).end());
    const auto at =
        std::ranges::find_if(children, [&](ExprId each) { return count_of(tree_, each, letter_) > 0; });
    std::vector<ExprId> others;
    std::copy_if(children.begin(), children.end(), std::back_inserter(others),
                 [&](ExprId each) { return each != *at; });
    if (others.size() + 1 != children.size()) return std::nullopt;
    switch (node.op) {
      case Op::negate:
        found_.value = negated(found_.value);
        return *at;
      case Op::add: {
        std::vector<ExprId> terms{found_.value};
        for (const ExprId each : others) terms.push_back(negated(each));
        found_.value = tree_.add({.op = Op::add, .span = node.span}, terms);
        return *at;
      }
      case Op::multiply:
        found_.value = over(found_.value, product_of(tree_, std::move(others), node.span));
        return *at;
      case Op::divide:
        found_.value = at == children.begin() ? product_of(tree_, {found_.value, others[0]}, node.span)
                                              : over(others[0], found_.value);
        return *at;
      case Op::function:
        if (node.function != Function::exp && node.function != Function::log) return std::nullopt;
        found_.value = tree_.add({.op = Op::function,
                                  .span = node.span,
                                  .function = node.function == Function::exp ? Function::log : Function::exp},
                                 std::span(&found_.value, 1));
        return *at;
      default:
        return std::nullopt;
    }
  }

  ExprId negated(ExprId id) {
    return tree_.add({.op = Op::negate, .span = tree_[id].span}, std::span(&id, 1));
  }
  ExprId over(ExprId above, ExprId below) {
    found_.divided_by.push_back(below);
    const std::array parts{above, below};
    return tree_.add({.op = Op::divide, .span = tree_[above].span}, parts);
  }

  ExprTree& tree_;
  SymbolId letter_;
  IsolatedLetter found_;
};

}  // namespace

std::optional<IsolatedLetter> isolated_letter(ExprTree& tree, ExprId left, ExprId right, SymbolId letter) {
  const bool plain = tree[left].rank == 0 && tree[right].rank == 0 && !has_operators(tree, left) &&
                     !has_operators(tree, right);
  if (!plain || hides(tree, left, letter) || hides(tree, right, letter)) return std::nullopt;
  const std::size_t on_left = count_of(tree, left, letter);
  if (on_left + count_of(tree, right, letter) != 1) return std::nullopt;
  return on_left == 1 ? Isolating(tree, letter, right).from(left) : Isolating(tree, letter, left).from(right);
}

}  // namespace rigor
