// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/fraction.h"

#include <fmt/format.h>
#include <ginac/ginac.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "algebra/engine/undecidable.h"
#include "algebra/ring/expansion.h"

namespace rigor {
namespace {

using GiNaC::ex;

constexpr double attempts_share = 2;  // all attempts together may expand so many times the limit
constexpr double expand_above =
    1000;  // products of more terms are expanded at once, so that the estimates stay near

/// How many terms (x_1 + … + x_n)^e has: C(n + e − 1, e), at most.
[[nodiscard]] double terms_of_expanded_power(double terms, int exponent) {
  double count = 1;
  for (int i = 1; i <= exponent; ++i) count *= (terms - 1 + i) / i;
  return std::ceil(count - 1e-6);
}

[[nodiscard]] Undecidable too_many_terms(double terms, double limit) {
  return Undecidable(fmt::format("expanding it takes up to {:.3g} terms, more than {:.0f}", terms, limit));
}

[[nodiscard]] double log2_of_sum(double a, double b) {
  return std::max(a, b) + std::log2(1 + std::exp2(-std::abs(a - b)));
}

[[nodiscard]] double coefficient_bits_of_term(const ex& term) {
  const ex& coefficient = GiNaC::is_a<GiNaC::mul>(term) ? term.op(term.nops() - 1) : term;
  if (!GiNaC::is_a<GiNaC::numeric>(coefficient)) return 0;
  return bit_size(cln::the<Rational>(GiNaC::ex_to<GiNaC::numeric>(coefficient).to_cl_N()));
}

[[nodiscard]] double coefficient_bits(const ex& expanded) {
  if (!GiNaC::is_a<GiNaC::add>(expanded)) return coefficient_bits_of_term(expanded);
  double bits = 0;
  for (std::size_t i = 0; i < expanded.nops(); ++i) {
    bits = log2_of_sum(bits, coefficient_bits_of_term(expanded.op(i)));
  }
  return bits;
}

[[nodiscard]] double coefficient_bits(const PackedPolynomial& expanded) {
  // As of GiNaC's terms: a factor 1 is no number.
  const auto bits_of_term = [&](std::size_t i) {
    const bool is_letters = expanded.coefficient(i).is_one() && !expanded.is_constant(i);
    return is_letters ? 0 : bit_size(expanded.coefficient(i).exact());
  };
  if (expanded.is_zero()) return bit_size(0);
  if (expanded.size() == 1) return bits_of_term(0);
  double bits = 0;
  for (std::size_t i = 0; i < expanded.size(); ++i) bits = log2_of_sum(bits, bits_of_term(i));
  return bits;
}

}  // namespace

Fraction to_fraction(const Rational& value) {
  return {PackedNumber(value), {}, cln::zerop(value) ? 0.0 : 1.0, bit_size(value)};
}

std::size_t term_count(const ex& expanded) {
  if (expanded.is_zero()) return 0;
  return GiNaC::is_a<GiNaC::add>(expanded) ? expanded.nops() : 1;
}

Fraction polynomial(const Numerator& expanded) {
  if (const PackedPolynomial* const known = expanded.known_expanded())
    return {expanded, {}, static_cast<double>(known->size()), coefficient_bits(*known)};
  const ex& value = expanded.written();
  return {expanded, {}, static_cast<double>(term_count(value)), coefficient_bits(value)};
}

/// Of the divisor with this base; their number if there is none.
std::size_t FractionArithmetic::position(const std::vector<Divisor>& divisors, const Numerator& base) const {
  const auto is_it = [&](const Divisor& each) { return each.base.is_equal(base, letters()); };
  return static_cast<std::size_t>(std::ranges::find_if(divisors, is_it) - divisors.begin());
}

/// The product of the factors of `wanted` that `present` lacks, and its number of terms.
Fraction FractionArithmetic::missing_factor(const std::vector<Divisor>& wanted,
                                            const std::vector<Divisor>& present) const {
  Fraction factor{.numerator = 1, .divisors = {}, .terms = 1, .bits = 0};
  for (const Divisor& each : wanted) {
    const std::size_t at = position(present, each.base);
    const int missing = each.exponent - (at == present.size() ? 0 : present[at].exponent);
    if (missing <= 0) continue;
    factor.numerator = factor.numerator.times(each.base.to_power(missing, letters()), letters());
    factor.terms *= terms_of_expanded_power(static_cast<double>(term_count(each.base)), missing);
  }
  return factor;
}

std::size_t FractionArithmetic::term_count(const Numerator& expanded) const {
  const PackedPolynomial* const polynomial = expanded.packed(letters());
  return polynomial == nullptr ? rigor::term_count(expanded.written()) : polynomial->size();
}

void FractionArithmetic::count(double units) {
  if (limits_.budget != nullptr) limits_.budget->count(static_cast<std::uint64_t>(units));
}

void FractionArithmetic::step() {
  count(1);
  if (++work_.steps > limits_.steps)
    throw Undecidable(fmt::format("more than {} steps of evaluation", limits_.steps));
}

void FractionArithmetic::check(const Fraction& value) const {
  if (value.terms > limits_.expanded_terms) throw too_many_terms(value.terms, limits_.expanded_terms);
  if (value.bits > largest_bits) {
    throw Undecidable(fmt::format("a coefficient may have more than {} digits", largest_digits));
  }
}

void FractionArithmetic::count_expansion(double estimated_terms) {
  count(price::expanded_term * std::min<double>(estimated_terms, limits_.expanded_terms));
  work_.terms += estimated_terms;
  const double limit = attempts_share * limits_.expanded_terms;
  if (work_.terms > limit) throw too_many_terms(work_.terms, limit);
}

ex FractionArithmetic::expanded(const ex& value, double estimated_terms) {
  count_expansion(estimated_terms);
  return expanded_polynomial(value);
}

Numerator FractionArithmetic::expanded(const Numerator& value, double estimated_terms) {
  count_expansion(estimated_terms);
  return value.expanded(letters());
}

void FractionArithmetic::expand(Fraction& value) {
  value.numerator = expanded(value.numerator, value.terms);
  value.terms = static_cast<double>(term_count(value.numerator));
  if (value.bits > largest_bits / 4) value.bits = coefficient_bits(value.numerator.written());
}

void FractionArithmetic::add(Fraction& total, const Fraction& summand) {
  if (summand.numerator.is_zero()) return;
  if (total.numerator.is_zero()) {
    total = summand;
    return;
  }
  if (total.divisors.empty() && summand.divisors.empty()) {
    total.numerator.add(summand.numerator, letters());
    total.terms += summand.terms;
  } else {
    const Fraction for_total = missing_factor(summand.divisors, total.divisors);
    const Fraction for_summand = missing_factor(total.divisors, summand.divisors);
    total.numerator = total.numerator.times(for_total.numerator, letters());
    total.numerator.add(summand.numerator.times(for_summand.numerator, letters()), letters());
    total.terms = total.terms * for_total.terms + summand.terms * for_summand.terms;
    for (const Divisor& each : summand.divisors) {
      const std::size_t at = position(total.divisors, each.base);
      if (at == total.divisors.size()) {
        total.divisors.push_back(each);
      } else {
        total.divisors[at].exponent = std::max(total.divisors[at].exponent, each.exponent);
      }
    }
  }
  total.bits = log2_of_sum(total.bits, summand.bits);
  check(total);
}

void FractionArithmetic::negate(Fraction& value) { value.numerator = value.numerator.negated(letters()); }

Fraction FractionArithmetic::multiply(const Fraction& a, const Fraction& b) {
  if (a.numerator.is_zero() || b.numerator.is_zero()) return {};
  Fraction product{a.numerator.times(b.numerator, letters()), a.divisors, a.terms * b.terms, a.bits + b.bits};
  for (const Divisor& each : b.divisors) divide_by(product, each.base, each.exponent);
  if (product.terms > expand_above && std::min(a.terms, b.terms) > 1) {
    if (product.terms > limits_.expanded_terms) {  // the factors may have fewer terms than was estimated
      Fraction left{a.numerator, {}, a.terms, a.bits};
      Fraction right{b.numerator, {}, b.terms, b.bits};
      expand(left);
      expand(right);
      product.terms = left.terms * right.terms;
    }
    check(product);
    expand(product);
  }
  check(product);
  return product;
}

Fraction FractionArithmetic::power(const Fraction& base, int exponent) {
  if (exponent == 0) return to_fraction(1);
  if (exponent < 0) return power(reciprocal(base), -exponent);
  if (base.numerator.is_zero()) return {};
  Fraction raised{1, base.divisors, terms_of_expanded_power(base.terms, exponent), exponent * base.bits};
  check(raised);
  raised.numerator = base.numerator.to_power(exponent, letters());
  for (Divisor& each : raised.divisors) each.exponent *= exponent;
  return raised;
}

Fraction FractionArithmetic::reciprocal(const Fraction& value) {
  Fraction result = to_fraction(1);
  for (const Divisor& each : value.divisors) {
    result.numerator = result.numerator.times(each.base.to_power(each.exponent, letters()), letters());
    result.terms *= terms_of_expanded_power(static_cast<double>(term_count(each.base)), each.exponent);
  }
  check(result);
  const auto divide = [&](const ex& factor, int exponent) {
    // GiNaC may have put a number there, or not: it counts nothing.
    if (GiNaC::is_a<GiNaC::numeric>(factor)) return divide_by_polynomial(result, factor, exponent);
    Fraction part{factor, {}, value.terms, value.bits};
    expand(part);
    divide_by_polynomial(result, part.numerator.written(), exponent);
  };
  if (divide_by_monomial(result, value)) return result;
  const ex& divisor = value.numerator.written();
  const auto factors = GiNaC::is_a<GiNaC::mul>(divisor) ? divisor.nops() : 1;
  for (std::size_t i = 0; i < factors; ++i) {
    const ex factor = factors == 1 ? divisor : divisor.op(i);
    if (GiNaC::is_a<GiNaC::power>(factor) && factor.op(1).info(GiNaC::info_flags::posint)) {
      divide(factor.op(0), GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_int());
    } else {
      divide(factor, 1);
    }
  }
  put_in_order(result.divisors);
  return result;
}

/// False where it is something else: then its factors are to be found, and their signs.
bool FractionArithmetic::divide_by_monomial(Fraction& value, const Fraction& divisor) {
  const PackedPolynomial* const monomial = divisor.numerator.known_expanded();
  if (monomial == nullptr || monomial->size() != 1) return false;
  value.numerator = value.numerator.times(PackedNumber(1) / monomial->coefficient(0), letters());
  monomial->for_each_power(0, [&](std::size_t letter, int exponent) {
    count_expansion(divisor.terms);  // of each factor
    divide_by(value, indeterminates_.value_at(letter), exponent);
  });
  put_in_order(value.divisors);
  return true;
}

/// In an order that is the same in every run, which GiNaC's order of factors is not.
void FractionArithmetic::put_in_order(std::vector<Divisor>& divisors) const {
  if (divisors.size() < 2) return;
  std::map<std::string, Divisor> in_order;
  for (const Divisor& each : divisors) in_order.emplace(indeterminates_.fingerprint(each.base), each);
  divisors.clear();
  for (const auto& [fingerprint, divisor] : in_order) divisors.push_back(divisor);
}

/// Takes the numeric content and the sign out, so that 2A − 2B and B − A are one divisor; a monomial is split
/// into its indeterminates.
void FractionArithmetic::divide_by_polynomial(Fraction& value, const ex& expanded, int exponent) const {
  if (expanded.is_zero()) throw Undecidable("a denominator is zero for all values of the symbols");
  if (GiNaC::is_a<GiNaC::numeric>(expanded)) {
    value.numerator = value.numerator.times(GiNaC::pow(expanded, -exponent), letters());
  } else if (GiNaC::is_a<GiNaC::mul>(expanded)) {
    for (std::size_t i = 0; i < expanded.nops(); ++i) divide_by_polynomial(value, expanded.op(i), exponent);
  } else if (GiNaC::is_a<GiNaC::power>(expanded)) {
    const int inner = GiNaC::ex_to<GiNaC::numeric>(expanded.op(1)).to_int();
    divide_by_polynomial(value, expanded.op(0), inner * exponent);
  } else {
    GiNaC::numeric content = expanded.integer_content();
    if (indeterminates_.unsigned_fingerprint(expanded).negative) content = -content;
    value.numerator = value.numerator.times(ex(GiNaC::pow(content, -exponent)), letters());
    const ex primitive = (expanded / content).expand();
    if (!primitive.is_equal(1)) divide_by(value, primitive, exponent);
  }
}

void FractionArithmetic::divide_by(Fraction& value, const Numerator& base, int exponent) const {
  const std::size_t known = position(value.divisors, base);
  if (known == value.divisors.size()) {
    value.divisors.push_back({base, exponent});
  } else {
    value.divisors[known].exponent += exponent;
  }
}

}  // namespace rigor
