// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/constant/measured_value.h"

#include <cmath>
#include <cstdlib>
#include <map>
#include <vector>

#include "check/doubt/digits.h"

namespace rigor {
namespace {

constexpr int deepest_definition = 64;
constexpr double pi = 3.14159265358979323846;
constexpr MeasuredValue no_value{NAN, {}};

class Measure {
 public:
  Measure(const ExprTree& tree, const Names& names, const MeasuredLetters& letters)
      : tree_(tree), names_(names), letters_(letters) {}

  /// NaN where it has no value. Recursion: as deep as the tree.
  [[nodiscard]] MeasuredValue of(ExprId id, int depth = 0) {
    if (depth > deepest_definition) return no_value;
    const ExprNode& node = tree_[id];
    const std::span<const ExprId> children = tree_.children(id);
    std::vector<MeasuredValue> values;  // each once: they may be deep
    for (const ExprId child : children) values.push_back(of(child, depth));
    switch (node.op) {
      case Op::number:
        return {std::strtod(tree_.digits(id).c_str(), nullptr)};
      case Op::symbol:
        return of_symbol(node.symbol, depth);
      case Op::negate:
        return {-values[0].number, values[0].dimension};
      case Op::divide:
        return {values[0].number / values[1].number, values[0].dimension - values[1].dimension};
      case Op::power:
        return {std::pow(values[0].number, node.exponent),
                values[0].dimension * SmallRational(node.exponent)};
      case Op::real_power:
        return power(values[0], children[1], values[1]);
      case Op::root:
        return {std::sqrt(values[0].number), values[0].dimension * SmallRational(1, 2)};
      case Op::absolute:
        return {std::abs(values[0].number), values[0].dimension};
      case Op::function:
        return values[0].dimension.is_none() ? of_function(node.function, values[0].number) : no_value;
      case Op::multiply: {
        MeasuredValue product{1};
        for (const MeasuredValue& factor : values)
          product = {product.number * factor.number, product.dimension + factor.dimension};
        return product;
      }
      case Op::add: {
        MeasuredValue sum{0, values[0].dimension};
        for (const MeasuredValue& term : values) {
          if (!(term.dimension == sum.dimension)) return no_value;
          sum.number += term.number;
        }
        return sum;
      }
      default:
        return no_value;
    }
  }

 private:
  [[nodiscard]] MeasuredValue of_symbol(SymbolId symbol, int depth) {
    if (const auto& unit = tree_.symbols[symbol].unit_of_measure) return {1, *unit};
    if (is_circle_number(tree_, names_, symbol)) return {pi};
    if (const auto body = body_of_definition(names_.scope, symbol)) {
      const auto known = defined_.find(symbol);
      if (known != defined_.end()) return known->second;
      const MeasuredValue value = of(*body, depth + 1);
      defined_.emplace(symbol, value);
      return value;
    }
    const auto letter = letters_.find(symbol);
    return letter == letters_.end() ? no_value : letter->second;
  }

  /// To a fraction of whole numbers, or of a number to a number.
  [[nodiscard]] MeasuredValue power(const MeasuredValue& base, ExprId exponent,
                                    const MeasuredValue& to) const {
    if (!to.dimension.is_none()) return no_value;
    const double number = std::pow(base.number, to.number);
    if (base.dimension.is_none()) return {number};
    const ExprNode& node = tree_[exponent];
    const auto whole = [&](std::size_t k) -> std::int64_t {
      const ExprId part = tree_.children(exponent)[k];
      const bool digits = tree_[part].op == Op::number && tree_.digits(part).size() <= 2;
      return digits ? std::atoi(tree_.digits(part).c_str()) : 0;
    };
    if (node.op != Op::divide || whole(0) == 0 || whole(1) == 0) return no_value;
    return {number, base.dimension * SmallRational(whole(0), whole(1))};
  }

  [[nodiscard]] static MeasuredValue of_function(Function function, double argument) {
    switch (function) {
      case Function::sin:
        return {std::sin(argument)};
      case Function::cos:
        return {std::cos(argument)};
      case Function::exp:
        return {std::exp(argument)};
      case Function::log:
        return {std::log(argument)};
      case Function::arcsin:
        return {std::asin(argument)};
      case Function::arccos:
        return {std::acos(argument)};
      case Function::arctan:
        return {std::atan(argument)};
    }
    return no_value;
  }

  const ExprTree& tree_;
  const Names& names_;
  const MeasuredLetters& letters_;
  std::map<SymbolId, MeasuredValue> defined_;
};

}  // namespace

std::optional<MeasuredValue> measured_value(const ExprTree& tree, const Names& names, ExprId expr,
                                            const MeasuredLetters& letters) {
  const MeasuredValue value = Measure(tree, names, letters).of(expr);
  return std::isfinite(value.number) && value.dimension.is_valid() ? std::optional(value) : std::nullopt;
}

}  // namespace rigor
