// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/doubt/approximate_value.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "check/doubt/digits.h"
#include "expr/tree/rough_value.h"

namespace rigor {
namespace {

constexpr int deepest = 64;  // definitions in definitions

/// NaN where it has no value.
double value_at(const ExprTree& tree, const Names& names, ExprId expr, int depth = 0) {
  if (depth > deepest) return NAN;
  return rough_value(tree, expr, [&](SymbolId symbol) {
    if (tree.symbols[symbol].unit_of_measure) return 1.0;
    if (is_circle_number(tree, names, symbol)) return std::numbers::pi;
    const auto body = body_of_definition(names.scope, symbol);
    return body ? value_at(tree, names, *body, depth + 1) : NAN;
  });
}

}  // namespace

std::optional<double> approximate_value(const ExprTree& tree, const Names& names, ExprId expr) {
  const double value = value_at(tree, names, expr);
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
