// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/generic_evaluator.h"

#include <ginac/ginac.h>

#include <algorithm>

namespace rigor {

using GiNaC::ex;

Fraction GenericDomain::number(const std::string& digits) { return to_fraction(from_digits(digits)); }

Fraction GenericDomain::divide(const Fraction& a, const Fraction& b) {
  const Fraction inverse =
      arithmetic_.reciprocal(b);  // throws where b is zero for all values, even for a = 0
  if (a.numerator.is_zero()) return {};
  Fraction quotient = arithmetic_.multiply(a, inverse);
  radicals_.rationalize(quotient);
  return quotient;
}

Fraction GenericDomain::power(const Fraction& base, int exponent) {
  Fraction raised = arithmetic_.power(base, exponent);
  if (exponent < 0) radicals_.rationalize(raised);
  return raised;
}

Fraction GenericDomain::function(Function function, const Fraction& argument) {
  if (!argument.numerator.is_zero()) throw Undecidable("functions are not decided yet");
  return function == Function::sin ? Fraction{} : to_fraction(1);
}

Fraction GenericDomain::value(SymbolId symbol, std::uint32_t frame, std::size_t component) {
  const Symbol& named = scope_->tree().symbols[symbol];
  const bool as_declared = !scope_->is_defined(symbol);
  if (as_declared && named.unit) return unit_vector(symbol, frame, component);
  auto canonical = static_cast<std::uint32_t>(component);
  if (as_declared && named.symmetric) canonical = std::min(canonical, 3 * (canonical % 3) + canonical / 3);
  if (!replaced_.empty()) {
    const auto replaced = replaced_.find({symbol, canonical});
    if (replaced != replaced_.end())
      return polynomial(radicals_.moved(replaced->second, template_frame, frame));
  }
  return polynomial(indeterminates_.coordinate(symbol, canonical, frame));
}

Fraction GenericDomain::unit_vector(SymbolId symbol, Frame frame, std::size_t component) {
  used_unit_vectors_ = true;
  const ex p = indeterminates_.coordinate(symbol, 0, frame);
  const ex q = indeterminates_.coordinate(symbol, 1, frame);
  const ex square = p * p + q * q;
  Fraction value = polynomial(component == 0 ? 2 * p : component == 1 ? 2 * q : 1 - square);
  value.divisors.push_back({1 + square, 1});
  return value;
}

ex GenericDomain::difference(const Fraction& left, const Fraction& right) {
  if (left.divisors.empty() && right.divisors.empty() && left.numerator.is_equal(right.numerator)) return 0;
  Fraction subtracted = right;
  arithmetic_.negate(subtracted);
  Fraction sum = left;
  arithmetic_.add(sum, subtracted);
  arithmetic_.expand(sum);
  return radicals_.reduced(sum.numerator);
}

ex GenericDomain::reduced(const ex& value, double terms) {
  return radicals_.reduced(arithmetic_.expanded(value, terms));
}

void GenericDomain::replace(SymbolId symbol, std::uint32_t component, const ex& worth) {
  for (auto& [key, known] : replaced_) {
    known = known.subs(indeterminates_.coordinate(symbol, component, template_frame) == worth).expand();
  }
  replaced_.emplace(std::pair(symbol, component), worth);
}

}  // namespace rigor
