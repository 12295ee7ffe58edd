// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/calculus/at_origin.h"

#include <algorithm>
#include <vector>

namespace rigor {
namespace {

class AtOrigin {
 public:
  AtOrigin(ExprTree& tree, const std::set<SymbolId>& variables) : tree_(tree), variables_(variables) {}

  std::optional<ExprId> value(ExprId id) {
    if (!holds_variable(id)) return id;
    const ExprNode node = tree_[id];
    if (node.rank > 0 || node.slot_count > 0) return std::nullopt;
    if (node.op == Op::symbol) return number(id, "0");
    std::vector<ExprId> children;
    for (const ExprId child : std::vector(tree_.children(id).begin(), tree_.children(id).end())) {
      const auto own = value(child);
      if (!own) return std::nullopt;
      children.push_back(*own);
    }
    switch (node.op) {
      case Op::add:
        std::erase_if(children, [&](ExprId each) { return tree_.is_zero_literal(each); });
        if (children.empty()) return number(id, "0");
        return children.size() == 1 ? children[0] : tree_.add(node, children);
      case Op::multiply:
        if (std::ranges::any_of(children, [&](ExprId each) { return tree_.is_zero_literal(each); }))
          return number(id, "0");
        return tree_.add(node, children);
      case Op::negate:
        return tree_.is_zero_literal(children[0]) ? children[0] : tree_.add(node, children);
      case Op::divide:
        if (holds_variable(tree_.children(id)[1])) return std::nullopt;
        return tree_.is_zero_literal(children[0]) ? children[0] : tree_.add(node, children);
      case Op::power:
        if (node.exponent <= 0) return std::nullopt;
        return tree_.is_zero_literal(children[0]) ? children[0] : tree_.add(node, children);
      case Op::function:
        return function(id, node, children);
      default:
        return std::nullopt;
    }
  }

 private:
  bool holds_variable(ExprId id) const {
    return std::ranges::any_of(symbols_in(tree_, id),
                               [&](SymbolId each) { return variables_.contains(each); });
  }

  ExprId number(ExprId of, const char* digits) { return tree_.add_number(tree_[of].span, digits); }

  std::optional<ExprId> function(ExprId id, const ExprNode& node, const std::vector<ExprId>& children) {
    const bool smooth =
        node.function == Function::sin || node.function == Function::cos || node.function == Function::exp;
    if (!smooth || children.size() != 1) return std::nullopt;
    if (!tree_.is_zero_literal(children[0])) return tree_.add(node, children);
    return number(id, node.function == Function::sin ? "0" : "1");
  }

  ExprTree& tree_;
  const std::set<SymbolId>& variables_;
};

}  // namespace

std::optional<ExprId> at_origin(ExprTree& tree, ExprId id, const std::set<SymbolId>& variables) {
  return AtOrigin(tree, variables).value(id);
}

}  // namespace rigor
