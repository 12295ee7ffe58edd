// SPDX-License-Identifier: GPL-3.0-or-later
// A rational function of indeterminates as one numerator over a product of denominators, never cancelled: the
// function is zero exactly if the expanded numerator is, and no greatest common divisor is ever computed.
#pragma once

#include <ginac/ex.h>

#include <vector>

#include "algebra/engine/attempt.h"
#include "algebra/engine/exact_number.h"
#include "algebra/engine/limits.h"
#include "algebra/packed/numerator.h"
#include "algebra/point/indeterminates.h"

namespace rigor {

/// One factor of a denominator: an expanded primitive polynomial (or a single indeterminate), not 0.
struct Divisor {
  Numerator base;
  int exponent = 1;  // positive
};

struct Fraction {
  Numerator numerator = {};
  std::vector<Divisor> divisors = {};  // their bases differ from each other, by more than the sign
  double terms = 0;                    // at most so many has the expanded numerator
  double bits = 0;                     // log₂ of the sum of its coefficients' sizes, about
};

[[nodiscard]] Fraction to_fraction(const Rational& value);
/// A polynomial that is expanded already.
[[nodiscard]] Fraction polynomial(const Numerator& expanded);
[[nodiscard]] std::size_t term_count(const GiNaC::ex& expanded);

/// Arithmetic of fractions within a budget. The number of terms is estimated before anything is expanded,
/// because an expansion cannot be broken off; above the limit for one polynomial, or twice the limit for all
/// attempts, it throws Undecidable with the figure.
class FractionArithmetic {
 public:
  FractionArithmetic(const Indeterminates& indeterminates, const Limits& limits, Work& work)
      : indeterminates_(indeterminates), limits_(limits), work_(work) {}

  void add(Fraction& total, const Fraction& summand);
  void negate(Fraction& value);
  [[nodiscard]] Fraction multiply(const Fraction& a, const Fraction& b);
  [[nodiscard]] Fraction power(const Fraction& base, int exponent);
  /// 1 / value; throws Undecidable if it is zero for all values of the indeterminates.
  [[nodiscard]] Fraction reciprocal(const Fraction& value);
  /// Expands the numerator and makes the estimates exact.
  void expand(Fraction& value);
  [[nodiscard]] GiNaC::ex expanded(const GiNaC::ex& value, double estimated_terms);

  [[nodiscard]] Numerator expanded(const Numerator& value, double estimated_terms);
  [[nodiscard]] const PackedLetters& letters() const { return indeterminates_.letters(); }

  [[nodiscard]] std::size_t term_count(const Numerator& expanded) const;
  /// Counts a step of evaluation.
  void step();
  /// Counts other work.
  void count(double units);
  [[nodiscard]] Budget* budget() const { return limits_.budget; }  // may be none

 private:
  void check(const Fraction& value) const;
  void count_expansion(double estimated_terms);
  [[nodiscard]] Fraction missing_factor(const std::vector<Divisor>& wanted,
                                        const std::vector<Divisor>& present) const;
  [[nodiscard]] std::size_t position(const std::vector<Divisor>& divisors, const Numerator& base) const;
  void divide_by(Fraction& value, const Numerator& base, int exponent) const;
  [[nodiscard]] bool divide_by_monomial(Fraction& value, const Fraction& divisor);
  void divide_by_polynomial(Fraction& value, const GiNaC::ex& expanded, int exponent) const;
  void put_in_order(std::vector<Divisor>& divisors) const;

  const Indeterminates& indeterminates_;
  Limits limits_;
  Work& work_;
};

}  // namespace rigor
