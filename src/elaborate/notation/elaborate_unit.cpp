// SPDX-License-Identifier: GPL-3.0-or-later
// Units of measure: a number times powers of positive symbols, one for each base unit.
#include <fmt/format.h>

#include <algorithm>

#include "elaborate/notation/elaborator.h"
#include "latex/unit/units.h"

namespace rigor {

/// The symbol of a base unit, which is positive.
ExprId Elaborator::base_unit(std::size_t which, Span span) {
  const std::string name = fmt::format("\\mathrm{{{}}}", base_units[which]);
  const SymbolId symbol =
      names_.resolve(tree_, {fmt::format("\\unit{{{}}}", base_units[which]), 0, false}, name, span);
  tree_.symbols[symbol].unit_of_measure = Dimension::of(static_cast<BaseQuantity>(which));
  tree_.symbols[symbol].declared = true;
  const ExprId unit = tree_.add({.op = Op::symbol, .span = span, .symbol = symbol});
  const std::string positive = fmt::format("{} is positive", name);
  const auto& assumptions = names_.assumptions();
  const bool known = std::any_of(assumptions.begin(), assumptions.end(),
                                 [&](const NamedAssumption& each) { return each.origin.text == positive; });
  if (!known) {
    const ExprId zero = tree_.add_number(span, "0");
    names_.assume({{zero, unit, {}, {}, Relation::less}, {positive, "", std::nullopt}});
  }
  return unit;
}

std::optional<Typed> Elaborator::unit(SyntaxId id) {
  const Span span = syntax_[id].span;
  std::string problem;
  const auto written = read_unit(syntax_.text(id), UnitNames::units, &problem);
  if (!written) return unsupported(span, std::move(problem));
  std::vector<ExprId> factors;
  const auto put = [&](ExprId base, std::int64_t exponent) {
    if (exponent == 0) return;
    if (exponent != 1) {
      base = tree_.add({.op = Op::power, .span = span, .exponent = static_cast<std::int32_t>(exponent)},
                       std::span(&base, 1));
    }
    factors.push_back(base);
  };
  const auto number = [&](std::int64_t value) { return tree_.add_number(span, std::to_string(value)); };
  if (written->factor.over() != 1) put(number(written->factor.over()), 1);
  if (written->factor.under() != 1) put(number(written->factor.under()), -1);
  if (written->ten != 0) put(number(10), written->ten);
  for (std::size_t k = 0; k < written->exponents.size(); ++k) {
    const SmallRational& exponent = written->exponents[k];
    if (exponent.under() != 1 || exponent.over() > 64 || exponent.over() < -64)
      return unsupported(span, "a unit to such a power is not decided");
    if (!exponent.is_zero()) put(base_unit(k, span), exponent.over());
  }
  if (written->ten > 64 || written->ten < -64)
    return unsupported(span, "a power of ten of such a size is not decided");
  Typed typed;
  if (factors.empty()) factors.push_back(number(1));
  typed.id = factors.size() == 1 ? factors[0] : tree_.add({.op = Op::multiply, .span = span}, factors);
  return typed;
}

}  // namespace rigor
