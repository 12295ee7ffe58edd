// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/name/measure_unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace rigor {
namespace {

/// The symbol of a base unit, which is positive.
ExprId base_unit(ExprTree& tree, Names& names, std::size_t which, Span span) {
  const std::string name = fmt::format("\\mathrm{{{}}}", base_units[which]);
  const SymbolId symbol =
      resolve(names.symbols, tree, {fmt::format("\\unit{{{}}}", base_units[which]), 0, false}, name, span);
  tree.symbols.write(symbol).unit_of_measure = Dimension::of(static_cast<BaseQuantity>(which));
  tree.symbols.write(symbol).declared = true;
  const ExprId unit = tree.add({.op = Op::symbol, .span = span, .symbol = symbol});
  const std::string positive = fmt::format("{} is positive", name);
  const bool known = std::ranges::any_of(
      names.scope.assumptions, [&](const NamedAssumption& each) { return each.origin.text == positive; });
  if (!known) {
    const ExprId zero = tree.add_number(span, "0");
    assume(names.scope, {{zero, unit, {}, {}, Relation::less}, {positive, "", std::nullopt}});
  }
  return unit;
}

}  // namespace

std::optional<ExprId> unit_expression(ExprTree& tree, Names& names, const WrittenUnit& unit, Span span,
                                      std::string* problem) {
  constexpr int largest_exponent = 64;
  std::vector<ExprId> factors;
  const auto put = [&](ExprId base, std::int64_t exponent) {
    if (exponent == 0) return;
    if (exponent != 1)
      base = tree.add({.op = Op::power, .span = span, .exponent = static_cast<std::int32_t>(exponent)},
                      std::span(&base, 1));
    factors.push_back(base);
  };
  const auto number = [&](std::int64_t value) { return tree.add_number(span, std::to_string(value)); };
  const auto fail = [&](std::string reason) {
    if (problem != nullptr) *problem = std::move(reason);
    return std::nullopt;
  };
  if (unit.factor.over() != 1) put(number(unit.factor.over()), 1);
  if (unit.factor.under() != 1) put(number(unit.factor.under()), -1);
  if (unit.ten != 0) put(number(10), unit.ten);
  for (std::size_t k = 0; k < unit.exponents.size(); ++k) {
    const SmallRational& exponent = unit.exponents[k];
    if (exponent.under() != 1 || exponent.over() > largest_exponent || exponent.over() < -largest_exponent)
      return fail("a unit to such a power is not decided");
    if (!exponent.is_zero()) put(base_unit(tree, names, k, span), exponent.over());
  }
  if (unit.ten > largest_exponent || unit.ten < -largest_exponent)
    return fail("a power of ten of such a size is not decided");
  if (factors.empty()) factors.push_back(number(1));
  return factors.size() == 1 ? factors[0] : tree.add({.op = Op::multiply, .span = span}, factors);
}

}  // namespace rigor
