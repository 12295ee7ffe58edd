// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/doubt/approximate_value.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "check/doubt/digits.h"

namespace rigor {
namespace {

constexpr int deepest = 64;  // definitions in definitions
constexpr double circle_number = 3.14159265358979323846;

class Approximation {
 public:
  Approximation(const ExprTree& tree, const Names& names) : tree_(tree), names_(names) {}

  /// NaN where it has no value. Recursion: as deep as the tree.
  [[nodiscard]] double of(ExprId id, int depth = 0) const {
    if (depth > deepest) return NAN;
    const ExprNode& node = tree_[id];
    const std::span<const ExprId> children = tree_.children(id);
    const auto child = [&](std::size_t k) { return of(children[k], depth); };
    switch (node.op) {
      case Op::number:
        return std::strtod(std::string(tree_.digits(id)).c_str(), nullptr);
      case Op::symbol:
        return of_symbol(node.symbol, depth);
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
        return of_function(node.function, child(0));
      case Op::add:
      case Op::multiply: {
        double value = node.op == Op::add ? 0 : 1;
        for (const ExprId each : children) {
          const double part = of(each, depth);
          value = node.op == Op::add ? value + part : value * part;
        }
        return value;
      }
      default:
        return NAN;
    }
  }

 private:
  [[nodiscard]] double of_symbol(SymbolId symbol, int depth) const {
    if (tree_.symbols[symbol].unit_of_measure) return 1;
    if (is_circle_number(tree_, names_, symbol)) return circle_number;
    const auto body = body_of_definition(names_.scope, symbol);
    return body ? of(*body, depth + 1) : NAN;
  }
  [[nodiscard]] static double of_function(Function function, double argument) {
    switch (function) {
      case Function::sin:
        return std::sin(argument);
      case Function::cos:
        return std::cos(argument);
      case Function::exp:
        return std::exp(argument);
      case Function::log:
        return std::log(argument);
      case Function::arcsin:
        return std::asin(argument);
      case Function::arccos:
        return std::acos(argument);
      case Function::arctan:
        return std::atan(argument);
    }
    return NAN;
  }

  const ExprTree& tree_;
  const Names& names_;
};

}  // namespace

std::optional<double> approximate_value(const ExprTree& tree, const Names& names, ExprId expr) {
  const double value = Approximation(tree, names).of(expr);
  return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

bool may_be_rounded_on_the_way(const ExprTree& tree, const Names& names, const Claim& claim,
                               const DigitComparison& compared) {
  constexpr double tolerance = 0.005;
  if (compared.agreement != Agreement::differs || !compared.of_decimals) return false;
  // `58.8\,\mathrm N` and 58.8 J are not near each other.
  const std::vector<SymbolId> symbols =
      symbols_reached(tree, names.scope, {claim.equation.left, claim.equation.right});
  if (std::ranges::any_of(symbols,
                          [&](SymbolId each) { return tree.symbols[each].unit_of_measure.has_value(); }))
    return false;
  const auto left = approximate_value(tree, names, claim.equation.left);
  const auto right = approximate_value(tree, names, claim.equation.right);
  return left && right && std::abs(*left - *right) <= tolerance * std::abs(*right);
}

}  // namespace rigor
