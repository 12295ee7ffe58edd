// SPDX-License-Identifier: GPL-3.0-or-later
// Units of measure: a number times powers of positive symbols, one for each base unit.
#include <fmt/format.h>

#include <algorithm>

#include "elaborate/notation/notations.h"
#include "latex/unit/units.h"

namespace rigor {
namespace {

/// The symbol of a base unit, which is positive.
ExprId base_unit(Reading& reading, std::size_t which, Span span) {
  const std::string name = fmt::format("\\mathrm{{{}}}", base_units[which]);
  const SymbolId symbol =
      symbol_named(reading, {fmt::format("\\unit{{{}}}", base_units[which]), 0, false}, name, span);
  reading.tree.symbols[symbol].unit_of_measure = Dimension::of(static_cast<BaseQuantity>(which));
  reading.tree.symbols[symbol].declared = true;
  const ExprId unit = reading.tree.add({.op = Op::symbol, .span = span, .symbol = symbol});
  const std::string positive = fmt::format("{} is positive", name);
  const bool known = std::ranges::any_of(*reading.names.scope.assumptions, [&](const NamedAssumption& each) {
    return each.origin.text == positive;
  });
  if (!known) {
    const ExprId zero = reading.tree.add_number(span, "0");
    assume(reading.names.scope, {{zero, unit, {}, {}, Relation::less}, {positive, "", std::nullopt}});
  }
  return unit;
}

}  // namespace

MaybeTyped elaborate_unit(Reading& reading, SyntaxId id, const Around&) {
  const Span span = reading.syntax[id].span;
  std::string problem;
  const auto written = read_unit(reading.syntax.text(id), UnitNames::units, &problem);
  if (!written) return unsupported(reading, span, std::move(problem));
  std::vector<ExprId> factors;
  const auto put = [&](ExprId base, std::int64_t exponent) {
    if (exponent == 0) return;
    if (exponent != 1) {
      base =
          reading.tree.add({.op = Op::power, .span = span, .exponent = static_cast<std::int32_t>(exponent)},
                           std::span(&base, 1));
    }
    factors.push_back(base);
  };
  const auto number = [&](std::int64_t value) {
    return reading.tree.add_number(span, std::to_string(value));
  };
  if (written->factor.over() != 1) put(number(written->factor.over()), 1);
  if (written->factor.under() != 1) put(number(written->factor.under()), -1);
  if (written->ten != 0) put(number(10), written->ten);
  for (std::size_t k = 0; k < written->exponents.size(); ++k) {
    const SmallRational& exponent = written->exponents[k];
    if (exponent.under() != 1 || exponent.over() > 64 || exponent.over() < -64)
      return unsupported(reading, span, "a unit to such a power is not decided");
    if (!exponent.is_zero()) put(base_unit(reading, k, span), exponent.over());
  }
  if (written->ten > 64 || written->ten < -64)
    return unsupported(reading, span, "a power of ten of such a size is not decided");
  if (factors.empty()) factors.push_back(number(1));
  const ExprId whole =
      factors.size() == 1 ? factors[0] : reading.tree.add({.op = Op::multiply, .span = span}, factors);
  return Typed{.id = whole};
}

}  // namespace rigor
