// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/verdict/rational_expression.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "algebra/parts/complex_sample.h"

namespace rigor {
namespace {

/// `1 + 2i`
std::optional<ExprId> add_complex(ExprTree& tree, Span span, const std::string& value) {
  const auto [re, im] = parts_of_text(value);
  const auto real = add_rational(tree, span, re);
  const auto imaginary = add_rational(tree, span, im);
  if (!real || !imaginary) return std::nullopt;
  const std::array factors{*imaginary, tree.add({.op = Op::imaginary_unit, .span = span})};
  const std::array terms{*real, tree.add({.op = Op::multiply, .span = span}, factors)};
  return tree.add({.op = Op::add, .span = span}, terms);
}

}  // namespace

std::optional<ExprId> add_rational(ExprTree& tree, Span span, const std::string& value) {
  if (value.find('.') != std::string::npos) return std::nullopt;
  if (value.ends_with('i')) return add_complex(tree, span, value);
  const bool negative = value.starts_with('-');
  const std::string digits = negative ? value.substr(1) : value;
  const auto slash = digits.find('/');
  ExprId number = tree.add_number(span, digits.substr(0, slash));
  if (slash != std::string::npos) {
    const ExprId parts[] = {number, tree.add_number(span, digits.substr(slash + 1))};
    number = tree.add({.op = Op::divide, .span = span}, parts);
  }
  return negative ? tree.add({.op = Op::negate, .span = span}, std::span(&number, 1)) : number;
}

bool may_be_rounded(const ExprTree& tree, const Equation& claim, const Sample& sample) {
  bool integral = false;
  bool decimal = false;
  for (const ExprId id : nodes_below(tree, {claim.left, claim.right})) {
    const ExprNode& node = tree[id];
    integral = integral || (node.op == Op::symbol && tree.symbols[node.symbol].integral);
    decimal = decimal || (node.op == Op::number && tree.digits(id).find('.') != std::string::npos);
  }
  const auto value = [](const std::string& exact) {
    const std::size_t slash = exact.find('/');
    const double below = slash == std::string::npos ? 1 : std::strtod(exact.c_str() + slash + 1, nullptr);
    return std::strtod(exact.c_str(), nullptr) / below;
  };
  constexpr double roughly = 0.1;
  const double left = value(sample.left);
  const double right = value(sample.right);
  return integral && decimal && std::abs(left - right) <= roughly * std::max(std::abs(left), std::abs(right));
}

}  // namespace rigor
