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

[[nodiscard]] std::vector<Divisor>::iterator find_divisor(std::vector<Divisor>& divisors, const ex& base) {
  return std::ranges::find_if(divisors, [&](const Divisor& each) { return each.base.is_equal(base); });
}

/// The product of the factors of `wanted` that `present` lacks, and its number of terms.
[[nodiscard]] Fraction missing_factor(const std::vector<Divisor>& wanted, std::vector<Divisor>& present) {
  Fraction factor{.numerator = 1, .divisors = {}, .terms = 1, .bits = 0};
  for (const Divisor& each : wanted) {
    const auto has = find_divisor(present, each.base);
    const int missing = each.exponent - (has == present.end() ? 0 : has->exponent);
    if (missing <= 0) continue;
    factor.numerator *= GiNaC::pow(each.base, missing);
    factor.terms *= terms_of_expanded_power(static_cast<double>(term_count(each.base)), missing);
  }
  return factor;
}

}  // namespace

Fraction to_fraction(const Rational& value) {
  return {GiNaC::numeric(value), {}, cln::zerop(value) ? 0.0 : 1.0, bit_size(value)};
}

std::size_t term_count(const ex& expanded) {
  if (expanded.is_zero()) return 0;
  return GiNaC::is_a<GiNaC::add>(expanded) ? expanded.nops() : 1;
}

Fraction polynomial(const ex& expanded) {
  return {expanded, {}, static_cast<double>(term_count(expanded)), coefficient_bits(expanded)};
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

ex FractionArithmetic::expanded(const ex& value, double estimated_terms) {
  count(price::expanded_term * std::min<double>(estimated_terms, limits_.expanded_terms));
  work_.terms += estimated_terms;
  const double limit = attempts_share * limits_.expanded_terms;
  if (work_.terms > limit) throw too_many_terms(work_.terms, limit);
  return expanded_polynomial(value);
}

void FractionArithmetic::expand(Fraction& value) {
  value.numerator = expanded(value.numerator, value.terms);
  value.terms = static_cast<double>(term_count(value.numerator));
  if (value.bits > largest_bits / 4) value.bits = coefficient_bits(value.numerator);
}

void FractionArithmetic::add(Fraction& total, const Fraction& summand) {
  if (summand.numerator.is_zero()) return;
  if (total.numerator.is_zero()) {
    total = summand;
    return;
  }
  if (total.divisors.empty() && summand.divisors.empty()) {
    total.numerator += summand.numerator;
    total.terms += summand.terms;
  } else {
    std::vector<Divisor> of_summand = summand.divisors;
    const Fraction for_total = missing_factor(summand.divisors, total.divisors);
    const Fraction for_summand = missing_factor(total.divisors, of_summand);
    total.numerator = total.numerator * for_total.numerator + summand.numerator * for_summand.numerator;
    total.terms = total.terms * for_total.terms + summand.terms * for_summand.terms;
    for (const Divisor& each : summand.divisors) {
      const auto has = find_divisor(total.divisors, each.base);
      if (has == total.divisors.end()) {
        total.divisors.push_back(each);
      } else {
        has->exponent = std::max(has->exponent, each.exponent);
      }
    }
  }
  total.bits = log2_of_sum(total.bits, summand.bits);
  check(total);
}

void FractionArithmetic::negate(Fraction& value) { value.numerator = -value.numerator; }

Fraction FractionArithmetic::multiply(const Fraction& a, const Fraction& b) {
  if (a.numerator.is_zero() || b.numerator.is_zero()) return {};
  Fraction product{a.numerator * b.numerator, a.divisors, a.terms * b.terms, a.bits + b.bits};
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
  raised.numerator = GiNaC::pow(base.numerator, exponent);
  for (Divisor& each : raised.divisors) each.exponent *= exponent;
  return raised;
}

Fraction FractionArithmetic::reciprocal(const Fraction& value) {
  Fraction result = to_fraction(1);
  for (const Divisor& each : value.divisors) {
    result.numerator *= GiNaC::pow(each.base, each.exponent);
    result.terms *= terms_of_expanded_power(static_cast<double>(term_count(each.base)), each.exponent);
  }
  check(result);
  const auto divide = [&](const ex& factor, int exponent) {
    // GiNaC may have put a number there, or not: it counts nothing.
    if (GiNaC::is_a<GiNaC::numeric>(factor)) return divide_by_polynomial(result, factor, exponent);
    Fraction part{factor, {}, value.terms, value.bits};
    expand(part);
    divide_by_polynomial(result, part.numerator, exponent);
  };
  const ex& divisor = value.numerator;
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
    value.numerator *= GiNaC::pow(expanded, -exponent);
  } else if (GiNaC::is_a<GiNaC::mul>(expanded)) {
    for (std::size_t i = 0; i < expanded.nops(); ++i) divide_by_polynomial(value, expanded.op(i), exponent);
  } else if (GiNaC::is_a<GiNaC::power>(expanded)) {
    const int inner = GiNaC::ex_to<GiNaC::numeric>(expanded.op(1)).to_int();
    divide_by_polynomial(value, expanded.op(0), inner * exponent);
  } else {
    GiNaC::numeric content = expanded.integer_content();
    if (indeterminates_.unsigned_fingerprint(expanded).negative) content = -content;
    value.numerator *= GiNaC::pow(content, -exponent);
    const ex primitive = (expanded / content).expand();
    if (!primitive.is_equal(1)) divide_by(value, primitive, exponent);
  }
}

void FractionArithmetic::divide_by(Fraction& value, const ex& base, int exponent) {
  const auto known = find_divisor(value.divisors, base);
  if (known == value.divisors.end()) {
    value.divisors.push_back({base, exponent});
  } else {
    known->exponent += exponent;
  }
}

}  // namespace rigor
