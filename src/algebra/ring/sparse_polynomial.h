// SPDX-License-Identifier: GPL-3.0-or-later
// Polynomials of our own, to be written down or searched term by term: unlike GiNaC's, their order of terms
// is the same in every run. Schoolbook arithmetic, whose operations are counted.
#pragma once

#include <ginac/ex.h>

#include <map>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>

#include "algebra/engine/exact_number.h"

namespace rigor {

using Exponents = std::string;                           // a byte for each variable: its exponent
using SparsePolynomial = std::map<Exponents, Rational>;  // no coefficient is 0

inline constexpr int largest_sparse_exponent = 100;

/// Expanded polynomials of GiNaC in given variables.
class SparseReader {
 public:
  explicit SparseReader(std::span<const GiNaC::ex> variables);

  [[nodiscard]] std::size_t variables() const { return positions_.size(); }
  /// Empty if it is not a polynomial, or an exponent is too large.
  [[nodiscard]] std::optional<SparsePolynomial> read(const GiNaC::ex& value) const;

 private:
  [[nodiscard]] bool take(const GiNaC::ex& factor, Exponents& monomial, Rational& coefficient) const;

  std::map<GiNaC::ex, std::size_t, GiNaC::ex_is_less> positions_;
};

/// More work than was allowed, or an exponent that is too large.
class TooLong : public std::runtime_error {
 public:
  TooLong() : std::runtime_error("too long") {}
};

/// Throws TooLong when its operations (a term added) are used up.
class SparseArithmetic {
 public:
  SparseArithmetic(std::size_t variables, std::size_t operations)
      : variables_(variables), left_(operations) {}

  [[nodiscard]] SparsePolynomial number(const Rational& value) const;
  [[nodiscard]] SparsePolynomial variable(std::size_t x) const;
  void add(SparsePolynomial& total, const SparsePolynomial& summand, const Rational& factor = 1);
  void add_product(SparsePolynomial& total, const SparsePolynomial& a, const SparsePolynomial& b,
                   const Rational& factor = 1);
  [[nodiscard]] SparsePolynomial product(const SparsePolynomial& a, const SparsePolynomial& b);
  [[nodiscard]] SparsePolynomial power(const SparsePolynomial& base, int exponent);
  /// The coefficient of x^exponent.
  [[nodiscard]] SparsePolynomial coefficient(const SparsePolynomial& value, std::size_t x, int exponent);
  /// The quotient q of value = q · divisor + rest, the divisor having a numeric coefficient at its highest
  /// power of x; the value becomes the rest, of a smaller degree in x than the divisor.
  [[nodiscard]] SparsePolynomial divide_in(std::size_t x, SparsePolynomial& value,
                                           const SparsePolynomial& divisor);
  /// value / divisor, if that is a polynomial.
  [[nodiscard]] std::optional<SparsePolynomial> quotient(SparsePolynomial value,
                                                         const SparsePolynomial& divisor);

 private:
  void count();
  void add_term(SparsePolynomial& total, const Exponents& monomial, const Rational& coefficient);

  std::size_t variables_;
  std::size_t left_;
};

[[nodiscard]] int degree(const SparsePolynomial& value, std::size_t x);

}  // namespace rigor
