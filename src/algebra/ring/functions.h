// SPDX-License-Identifier: GPL-3.0-or-later
// Functions at the generic point. The argument of sin, cos and exp is a sum of rational multiples of
// quantities (monomials over products of denominators); each distinct quantity Q has a base angle Q/d, where
// d is a common denominator of all multiples. Its cosine C and sine S are indeterminates with S² = 1 − C²,
// its exponential E is a positive one; multiples follow by Chebyshev's recursion, sums by the addition
// formulas, and exp of a sum is a product of powers. Multiples of π/12 have roots for their sine and cosine.
//
// ln of a fraction is Σ e ln|f| over its factors f^e, each ln|f| an indeterminate; exp(n ln|f|) is |f|^n
// again. arctan u and arcsin u are indeterminates A, with sin A and cos A in u. A power with any exponent is
// b^y = exp(y ln b). What has a value only for positive (or small) arguments says so of them: a statement is
// meant where all of it has a value.
//
// Sound: all of these are identities. Complete only as far as these relations go.
#pragma once

#include <map>
#include <optional>
#include <stdexcept>
#include <vector>

#include "algebra/ring/radicals.h"
#include "expr/tree/tree.h"

namespace rigor {

/// The common denominator of multiples has to be a multiple of this: the proof starts again with it.
class FinerAngles : public std::runtime_error {
 public:
  explicit FinerAngles(int divisor) : std::runtime_error("angles need a finer unit"), divisor_(divisor) {}
  [[nodiscard]] int divisor() const { return divisor_; }

 private:
  int divisor_;
};

inline constexpr int largest_multiple = 12;  // of an angle, and of the fractions of angles

class Functions {
 public:
  /// The functions of Q/d; each is created where it is needed.
  struct Quantity {
    GiNaC::ex cosine = 0;
    GiNaC::ex sine = 0;
    GiNaC::ex exponential = 0;
  };

  Functions(Indeterminates& indeterminates, FractionArithmetic& arithmetic, Signs& signs, Radicals& radicals,
            int divisor)
      : indeterminates_(indeterminates),
        arithmetic_(arithmetic),
        signs_(signs),
        radicals_(radicals),
        divisor_(divisor) {}

  /// An indeterminate for the value of a function.
  struct Value {
    Function function = Function::log;  // log, arcsin or arctan
    GiNaC::ex argument;
    GiNaC::ex symbol;
  };

  /// Throws FinerAngles where the angles' unit is too coarse.
  [[nodiscard]] Fraction value(Function function, Fraction argument);
  [[nodiscard]] Fraction real_power(const Fraction& base, const Fraction& exponent);
  [[nodiscard]] Fraction circle_number();
  [[nodiscard]] bool any() const { return !quantities_.empty() || !values_.empty(); }
  [[nodiscard]] const std::map<GiNaC::ex, Quantity, GiNaC::ex_is_less>& by_quantity() const {
    return quantities_;
  }
  [[nodiscard]] const std::vector<Value>& values() const { return values_; }
  /// π and the exponentials that there are.
  [[nodiscard]] std::vector<GiNaC::ex> never_zero() const;
  [[nodiscard]] bool is_circle_number(const GiNaC::ex& symbol) const { return symbol.is_equal(circle_); }
  [[nodiscard]] int divisor() const { return divisor_; }  // d

 private:
  struct Multiple {
    GiNaC::ex quantity;
    int count = 0;  // of Q/d
  };
  struct Direction {  // of an angle
    Fraction cosine;
    Fraction sine;
  };
  struct Argument {
    std::vector<Multiple> multiples;  // in an order that is the same in every run
    int twelfths = 0;                 // of π, of an angle
  };
  void simplify(Fraction& value);
  [[nodiscard]] Argument taken_apart(Fraction argument, bool angle);
  [[nodiscard]] Direction direction(const Multiple& of);
  [[nodiscard]] Direction direction_of_twelfths(int count);
  [[nodiscard]] Direction direction_of(const Value& angle);
  [[nodiscard]] Direction turned(const Direction& a, const Direction& b);
  [[nodiscard]] Fraction angle_function(Function function, Fraction argument);
  [[nodiscard]] Fraction exponential(const std::vector<Multiple>& multiples);
  [[nodiscard]] Fraction base_power(const GiNaC::ex& quantity, int count);
  [[nodiscard]] Fraction power_of_argument(const Value& logarithm, int count);

  [[nodiscard]] Fraction logarithm(Fraction argument);
  [[nodiscard]] Fraction logarithm_of_polynomial(const GiNaC::ex& expanded);
  [[nodiscard]] Fraction logarithm_of_factor(const GiNaC::ex& factor);
  [[nodiscard]] Fraction logarithm_of_number(const Rational& positive);
  void note_positive(const Fraction& value);
  [[nodiscard]] Fraction arc(Function function, Fraction argument);
  [[nodiscard]] std::optional<Fraction> known_arc(Function function, const Fraction& argument);
  [[nodiscard]] Fraction twelfths_of_circle(int count);
  [[nodiscard]] const Value& value_named(Function function, const GiNaC::ex& argument);
  [[nodiscard]] const Value* value_of_symbol(const GiNaC::ex& symbol) const;
  [[nodiscard]] Fraction fraction_of(const GiNaC::ex& value);
  [[nodiscard]] Fraction scaled(Fraction value, const Rational& factor);

  Indeterminates& indeterminates_;
  FractionArithmetic& arithmetic_;
  Signs& signs_;
  Radicals& radicals_;
  int divisor_;
  std::map<GiNaC::ex, Quantity, GiNaC::ex_is_less> quantities_;
  std::vector<Value> values_;
  GiNaC::ex circle_ = 0;  // π, where it is needed
};

}  // namespace rigor
