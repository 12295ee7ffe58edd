// SPDX-License-Identifier: GPL-3.0-or-later
// Integrals of Gaussians to infinity, which have no antiderivative among the elementary functions: ∫ x^n
// e^{−ax²} dx, and over the whole line ∫ e^{−ax² + bx + c} dx = √(π/a) e^{b²/4a + c}. That a is positive is a
// condition.
#include <array>

#include "check/question/integral_value.h"
#include "expr/calculus/gaussian.h"

namespace rigor {

/// −ax² + bx + c, by its coefficients.
std::optional<std::array<ExprId, 3>> IntegralValues::quadratic(ExprId argument, const Running& running,
                                                               Span span) {
  const auto terms = integrand_terms(tree_, argument, running);
  if (!terms) return std::nullopt;
  std::array<std::vector<ExprId>, 3> parts;
  for (const IntegrandTerm& term : *terms) {
    const auto power = power_of_variable(term.running, running);
    if (!power || *power > 2) return std::nullopt;
    parts[static_cast<std::size_t>(*power)].push_back(product_of(tree_, term.constant, span));
  }
  if (parts[2].empty()) return std::nullopt;
  return std::array{total(parts[0], span), total(parts[1], span), total(parts[2], span)};
}

/// n of x^n, if the factors are nothing else.
std::optional<int> IntegralValues::power_of_variable(const std::vector<ExprId>& factors,
                                                     const Running& running) const {
  int power = 0;
  for (const ExprId factor : factors) {
    const ExprNode& node = tree_[factor];
    const ExprId base = node.op == Op::power ? tree_.children(factor)[0] : factor;
    if (tree_[base].op != Op::symbol || tree_[base].symbol != running.variable) return std::nullopt;
    const int exponent = node.op == Op::power ? node.exponent : 1;
    if (exponent < 1 || exponent > highest_gaussian_power) return std::nullopt;
    power += exponent;
  }
  return power <= highest_gaussian_power ? std::optional(power) : std::nullopt;
}

ExprId IntegralValues::circle_number(Span span) {
  for (std::uint32_t k = 0; k < tree_.symbols.size(); ++k) {
    if (tree_.symbols[SymbolId{k}].circle_number)
      return tree_.add({.op = Op::symbol, .span = span, .symbol = SymbolId{k}});
  }
  const SymbolId circle = tree_.symbols.add({.name = "\\pi", .circle_number = true, .first_seen = span});
  return tree_.add({.op = Op::symbol, .span = span, .symbol = circle});
}

bool IntegralValues::is_positive(ExprId id, Span span, IntegralValue& result) {
  if (has_complex_numbers(tree_, id)) return false;
  const ExprId zero = tree_.add_number(span, "0");
  Equation positive;
  positive.left = zero;
  positive.right = id;
  positive.relation = Relation::less;
  Equation other;
  other.left = id;
  other.right = zero;
  other.relation = Relation::less_or_equal;
  if (holds(positive)) return true;
  if (holds(other)) return false;
  result.conditions.push_back(positive);
  return true;
}

std::optional<ExprId> IntegralValues::gaussian(const IntegrandTerm& term, const Running& running,
                                               const Integral& integral, Span span, IntegralValue& result) {
  const bool half_line = integral.lower->at && tree_.is_zero_literal(*integral.lower->at);
  if (integral.upper->infinity <= 0 || (!half_line && integral.lower->infinity >= 0)) return std::nullopt;
  std::vector<ExprId> exponents;
  std::vector<ExprId> others;
  for (const ExprId factor : term.running) {
    const bool exponential = tree_[factor].op == Op::function && tree_[factor].function == Function::exp;
    if (exponential) exponents.push_back(tree_.children(factor)[0]);
    if (!exponential) others.push_back(factor);
  }
  const auto n = power_of_variable(others, running);
  if (!n || exponents.empty()) return std::nullopt;
  const auto parts = quadratic(total(exponents, span), running, span);
  if (!parts) return std::nullopt;
  const auto [c, b, slope] = *parts;
  const ExprId a = negative(slope, span);
  const auto add = [&](ExprNode node, std::vector<ExprId> children) {
    node.span = span;
    return tree_.add(node, children);
  };
  const bool shifted = !tree_.is_zero_literal(b) || !tree_.is_zero_literal(c);
  if (shifted && (*n > 0 || half_line)) return std::nullopt;
  if (!is_positive(a, span, result)) return std::nullopt;
  if (shifted) {
    const ExprId root = add({.op = Op::root}, {add({.op = Op::divide}, {circle_number(span), a})});
    const ExprId square = add({.op = Op::power, .exponent = 2}, {b});
    const ExprId four = add({.op = Op::multiply}, {tree_.add_number(span, "4"), a});
    const ExprId exponent = add({.op = Op::add}, {add({.op = Op::divide}, {square, four}), c});
    return add({.op = Op::multiply},
               {root, add({.op = Op::function, .function = Function::exp}, {exponent})});
  }
  const GaussianMoment moment = gaussian_moment(*n, half_line);
  const ExprId above = tree_.add_number(span, std::to_string(moment.numerator));
  if (moment.numerator == 0) return above;
  std::vector<ExprId> below{tree_.add_number(span, std::to_string(moment.denominator))};
  if (moment.twice > 1) below.push_back(add({.op = Op::power, .exponent = moment.twice / 2}, {a}));
  const ExprId quotient = add({.op = Op::divide}, {above, product_of(tree_, below, span)});
  if (!moment.root_of_pi) return quotient;
  return add({.op = Op::multiply},
             {quotient, add({.op = Op::root}, {add({.op = Op::divide}, {circle_number(span), a})})});
}

}  // namespace rigor
