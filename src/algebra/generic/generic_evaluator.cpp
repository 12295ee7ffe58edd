// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/generic/generic_evaluator.h"

#include <ginac/ginac.h>

#include <algorithm>
#include <array>

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

void GenericDomain::check_root(const Fraction& square) const {
  if (is_within(signs_.of(square), Sign::negative)) throw NoRealValue("a root of a negative number");
}

Fraction GenericDomain::value(SymbolId symbol, std::uint32_t frame, std::size_t component) {
  const Symbol& named = scope_->tree().symbols[symbol];
  const bool as_declared = !scope_->is_defined(symbol);
  if (as_declared && named.unit) return unit_vector(symbol, frame, component);
  if (as_declared && named.rotation) return rotation(symbol, frame, component);
  const auto canonical =
      static_cast<std::uint32_t>(as_declared ? canonical_component(named, component) : component);
  if (!replaced_.empty()) {
    const auto replaced = replaced_.find({symbol, canonical});
    if (replaced != replaced_.end())
      return polynomial(radicals_.moved(replaced->second, template_frame, frame));
  }
  return polynomial(indeterminates_.coordinate_value(symbol, canonical, frame));
}

Fraction GenericDomain::unit_vector(SymbolId symbol, Frame frame, std::size_t component) {
  used_unit_vectors_ = true;
  if (as_coordinates_.contains(symbol)) return unit_vector_by_coordinates(symbol, frame, component);
  const PackedPolynomial p = packed_coordinate(symbol, 0, frame);
  const PackedPolynomial q = packed_coordinate(symbol, 1, frame);
  const PackedPolynomial square = p * p + q * q;
  Fraction value = packed(component == 0 ? 2 * p : component == 1 ? 2 * q : 1 - square);
  value.divisors.push_back({packed(1 + square).numerator, 1});
  return value;
}

PackedPolynomial GenericDomain::packed_coordinate(SymbolId symbol, std::uint32_t component, Frame frame) {
  return *indeterminates_.coordinate_value(symbol, component, frame).known_expanded();
}

Fraction GenericDomain::packed(const PackedPolynomial& value) const {
  return polynomial(Numerator(value, indeterminates_.letters()));
}

Fraction GenericDomain::unit_vector_by_coordinates(SymbolId symbol, Frame frame, std::size_t component) {
  std::array<ex, 3> n;
  for (std::uint32_t i = 0; i < 3; ++i) n[i] = indeterminates_.coordinate(symbol, i, frame);
  if (frame != common_frame) radicals_.relate(n[2], 1 - n[0] * n[0] - n[1] * n[1]);
  return polynomial(n[component]);
}

/// R_ij = ((w² − v·v) δ_ij + 2 v_i v_j − 2 w ε_ijk v_k) / (w² + v·v), from Rodrigues' parameters.
Fraction GenericDomain::rotation(SymbolId symbol, Frame frame, std::size_t component) {
  used_rotations_ = true;
  const PackedPolynomial w = packed_coordinate(symbol, 0, frame);
  std::array<PackedPolynomial, 3> v;
  for (std::uint32_t i = 0; i < 3; ++i) v[i] = packed_coordinate(symbol, i + 1, frame);
  const PackedPolynomial square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  const std::size_t i = component / 3;
  const std::size_t j = component % 3;
  const auto sign = permutation_sign(static_cast<int>(i), static_cast<int>(j), static_cast<int>(3 - i - j));
  Fraction value =
      packed(i == j ? w * w - square + 2 * v[i] * v[i] : 2 * v[i] * v[j] - 2 * sign * w * v[3 - i - j]);
  value.divisors.push_back({packed(w * w + square).numerator, 1});
  return value;
}

Numerator GenericDomain::difference(const Fraction& left, const Fraction& right) {
  const PackedLetters& letters = indeterminates_.letters();
  const auto same = [&](const Divisor& a, const Divisor& b) {
    return a.exponent == b.exponent && a.base.is_equal(b.base, letters);
  };
  if (std::ranges::equal(left.divisors, right.divisors, same) &&
      left.numerator.is_equal(right.numerator, letters))
    return {};
  Fraction subtracted = right;
  arithmetic_.negate(subtracted);
  Fraction sum = left;
  arithmetic_.add(sum, subtracted);
  arithmetic_.expand(sum);
  return sum.numerator.is_zero() ? Numerator() : radicals_.reduced(sum.numerator);
}

Fraction GenericDomain::subtracted(const Fraction& right, const Fraction& left) {
  Fraction negated = left;
  arithmetic_.negate(negated);
  Fraction total = right;
  arithmetic_.add(total, negated);
  return total;
}

ex GenericDomain::with_sign_of(const Fraction& value) {
  Fraction same = polynomial(value.numerator);
  same.terms = value.terms;
  for (const Divisor& each : value.divisors) {
    const Sign sign = rigor::power(signs_.of(each.base), -each.exponent);
    if (sign == Sign::negative) arithmetic_.negate(same);
    if (sign != Sign::negative && sign != Sign::positive) {
      same = arithmetic_.multiply(same, polynomial(each.base));
    }
  }
  arithmetic_.expand(same);
  return radicals_.reduced(same.numerator);
}

/// Found by its parts, or as the sign of a sum that has been noted.
Sign GenericDomain::sign_as_written(const Fraction& value) const {
  if (!notes_signs_) return Sign::any;
  const Sign sign = signs_.of(value);
  if (sign != Sign::any || !value.divisors.empty()) return sign;
  for (const Signs::Fact& fact : signs_.facts()) {
    if (fact.value.is_equal(value.numerator.written())) return fact.sign;
  }
  return sign;
}

void GenericDomain::note_sign(const Fraction& value, Sign sign) {
  const bool one_sided = is_within(sign, Sign::not_negative) || is_within(sign, Sign::not_positive);
  if (!notes_signs_ || !one_sided || is_within(signs_.of(value), sign)) return;
  const ex same = with_sign_of(value);
  const bool negative = is_within(sign, Sign::not_positive);
  signs_.add_fact(negative ? (-same).expand() : same, negative ? opposite(sign) : sign);
}

Numerator GenericDomain::reduced(const Numerator& value, double terms) {
  return radicals_.reduced(arithmetic_.expanded(value, terms));
}

void GenericDomain::replace(SymbolId symbol, std::uint32_t component, const ex& worth) {
  for (auto& [key, known] : replaced_) {
    known = known.subs(indeterminates_.coordinate(symbol, component, template_frame) == worth).expand();
  }
  replaced_.emplace(std::pair(symbol, component), worth);
}

}  // namespace rigor
