// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/sparse_polynomial.h"

#include <ginac/ginac.h>

#include <algorithm>
#include <utility>

#include "algebra/engine/terms.h"

namespace rigor {

using GiNaC::ex;

namespace {

/// a · b; empty where an exponent is too large.
[[nodiscard]] std::optional<Exponents> monomials_multiplied(const Exponents& a, const Exponents& b) {
  Exponents result = a;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const int sum = a[i] + b[i];
    if (sum > largest_sparse_exponent) return std::nullopt;
    result[i] = static_cast<char>(sum);
  }
  return result;
}

}  // namespace

SparseReader::SparseReader(std::span<const ex> variables) {
  for (const ex& each : variables) positions_.emplace(each, positions_.size());
}

std::optional<SparsePolynomial> SparseReader::read(const ex& value) const {
  SparsePolynomial polynomial;
  const bool sum = GiNaC::is_a<GiNaC::add>(value);
  for (std::size_t i = 0; i < (sum ? value.nops() : 1); ++i) {
    Exponents monomial(positions_.size(), '\0');
    Rational coefficient = 1;
    const ex term = sum ? value.op(i) : value;
    const bool factors = GiNaC::is_a<GiNaC::mul>(term);
    for (std::size_t k = 0; k < (factors ? term.nops() : 1); ++k) {
      if (!take(factors ? term.op(k) : term, monomial, coefficient)) return std::nullopt;
    }
    if (!cln::zerop(coefficient)) polynomial.emplace(std::move(monomial), coefficient);
  }
  return polynomial;
}

bool SparseReader::take(const ex& factor, Exponents& monomial, Rational& coefficient) const {
  if (is_number(factor)) {
    coefficient = coefficient * cln::the<Rational>(GiNaC::ex_to<GiNaC::numeric>(factor).to_cl_N());
    return true;
  }
  const bool raised = GiNaC::is_a<GiNaC::power>(factor);
  const auto at = positions_.find(raised ? factor.op(0) : factor);
  if (at == positions_.end()) return false;
  const int exponent = raised ? GiNaC::ex_to<GiNaC::numeric>(factor.op(1)).to_int() : 1;
  if (exponent < 0 || exponent > largest_sparse_exponent) return false;
  monomial[at->second] = static_cast<char>(exponent);
  return true;
}

int degree(const SparsePolynomial& value, std::size_t x) {
  int highest = 0;
  for (const auto& [monomial, number] : value) highest = std::max<int>(highest, monomial[x]);
  return highest;
}

void SparseArithmetic::count() {
  if (left_ == 0) throw TooLong();
  --left_;
}

void SparseArithmetic::add_term(SparsePolynomial& total, const Exponents& monomial,
                                const Rational& coefficient) {
  count();
  const auto [at, is_new] = total.try_emplace(monomial, coefficient);
  if (is_new) return;
  at->second = at->second + coefficient;
  if (cln::zerop(at->second)) total.erase(at);
}

SparsePolynomial SparseArithmetic::number(const Rational& value) const {
  SparsePolynomial polynomial;
  if (!cln::zerop(value)) polynomial.emplace(Exponents(variables_, '\0'), value);
  return polynomial;
}

SparsePolynomial SparseArithmetic::variable(std::size_t x) const {
  Exponents monomial(variables_, '\0');
  monomial[x] = 1;
  return {{std::move(monomial), 1}};
}

void SparseArithmetic::add(SparsePolynomial& total, const SparsePolynomial& summand, const Rational& factor) {
  for (const auto& [monomial, number] : summand) add_term(total, monomial, factor * number);
}

void SparseArithmetic::add_product(SparsePolynomial& total, const SparsePolynomial& a,
                                   const SparsePolynomial& b, const Rational& factor) {
  for (const auto& [of_a, number_of_a] : a) {
    for (const auto& [of_b, number_of_b] : b) {
      const auto monomial = monomials_multiplied(of_a, of_b);
      if (!monomial) throw TooLong();
      add_term(total, *monomial, factor * number_of_a * number_of_b);
    }
  }
}

SparsePolynomial SparseArithmetic::product(const SparsePolynomial& a, const SparsePolynomial& b) {
  SparsePolynomial total;
  add_product(total, a, b);
  return total;
}

SparsePolynomial SparseArithmetic::power(const SparsePolynomial& base, int exponent) {
  SparsePolynomial result = number(1);
  for (int k = 0; k < exponent; ++k) result = product(result, base);
  return result;
}

SparsePolynomial SparseArithmetic::coefficient(const SparsePolynomial& value, std::size_t x, int exponent) {
  SparsePolynomial result;
  for (const auto& [monomial, number] : value) {
    count();
    if (monomial[x] != exponent) continue;
    Exponents without = monomial;
    without[x] = '\0';
    result.emplace(std::move(without), number);
  }
  return result;
}

SparsePolynomial SparseArithmetic::divide_in(std::size_t x, SparsePolynomial& value,
                                             const SparsePolynomial& divisor) {
  const int lowest = degree(divisor, x);
  const Rational leading = coefficient(divisor, x, lowest).begin()->second;
  SparsePolynomial whole;
  for (int highest = degree(value, x); highest >= lowest; highest = std::min(highest - 1, degree(value, x))) {
    Exponents shift(variables_, '\0');
    shift[x] = static_cast<char>(highest - lowest);
    const SparsePolynomial part = product(coefficient(value, x, highest), {{shift, 1 / leading}});
    add(whole, part);
    add_product(value, part, divisor, -1);
  }
  return whole;
}

/// By last terms: their order is one of monomials, so that the last term of a product is that of the
/// factors'.
std::optional<SparsePolynomial> SparseArithmetic::quotient(SparsePolynomial value,
                                                           const SparsePolynomial& divisor) {
  if (divisor.empty()) return std::nullopt;
  const auto& [last, number] = *divisor.rbegin();
  SparsePolynomial whole;
  while (!value.empty()) {
    Exponents monomial = value.rbegin()->first;
    for (std::size_t i = 0; i < monomial.size(); ++i) {
      if (monomial[i] < last[i]) return std::nullopt;
      monomial[i] = static_cast<char>(monomial[i] - last[i]);
    }
    const SparsePolynomial part{{monomial, value.rbegin()->second / number}};
    add(whole, part);
    add_product(value, part, divisor, -1);
  }
  return whole;
}

}  // namespace rigor
