// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/tree/rough_value.h"

#include <cstdlib>
#include <string>

namespace rigor {
double rough_value(const ExprTree& tree, ExprId root, const std::function<double(SymbolId)>& of_symbol) {
  const ExprNode& node = tree[root];
  const std::span<const ExprId> children = tree.children(root);
  const auto child = [&](std::size_t k) { return rough_value(tree, children[k], of_symbol); };
  switch (node.op) {
    case Op::number:
      return std::strtod(std::string(tree.digits(root)).c_str(), nullptr);
    case Op::symbol:
      return node.slot_count == 0 && node.particle == no_particle ? of_symbol(node.symbol) : NAN;
    case Op::negate:
      return -child(0);
    case Op::divide:
      return child(0) / child(1);
    case Op::power:
      return std::pow(child(0), node.exponent);
    case Op::real_power:
      return std::pow(child(0), child(1));
    case Op::root:
      return std::sqrt(child(0));
    case Op::absolute:
      return std::abs(child(0));
    case Op::function:
      return function_value(node.function, child(0));
    case Op::add:
    case Op::multiply: {
      double value = node.op == Op::add ? 0 : 1;
      for (std::size_t k = 0; k < children.size(); ++k)
        value = node.op == Op::add ? value + child(k) : value * child(k);
      return value;
    }
    default:
      return NAN;
  }
}

}  // namespace rigor
