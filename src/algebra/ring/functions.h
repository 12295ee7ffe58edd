// SPDX-License-Identifier: GPL-3.0-or-later
// sin, cos and exp at the generic point. The argument is a sum of rational multiples of quantities (monomials
// over products of denominators); each distinct quantity Q has a base angle Q/d, where d is a common
// denominator of all multiples. Its cosine C and sine S are indeterminates with S² = 1 − C², its exponential
// E is a positive one; multiples follow by Chebyshev's recursion, sums by the addition formulas, and exp of a
// sum is a product of powers. Sound: all of these are identities. What else relates the functions (π, say) is
// not known here.
#pragma once

#include <map>
#include <stdexcept>

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

  /// Throws FinerAngles where the angles' unit is too coarse.
  [[nodiscard]] Fraction value(Function function, Fraction argument);
  [[nodiscard]] bool any() const { return !quantities_.empty(); }
  [[nodiscard]] const std::map<GiNaC::ex, Quantity, GiNaC::ex_is_less>& by_quantity() const {
    return quantities_;
  }
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
  [[nodiscard]] std::vector<Multiple> multiples(Fraction argument);
  [[nodiscard]] Direction direction(const Multiple& of);
  [[nodiscard]] Direction turned(const Direction& a, const Direction& b);
  [[nodiscard]] Fraction exponential(const std::vector<Multiple>& multiples);

  Indeterminates& indeterminates_;
  FractionArithmetic& arithmetic_;
  Signs& signs_;
  Radicals& radicals_;
  int divisor_;
  std::map<GiNaC::ex, Quantity, GiNaC::ex_is_less> quantities_;
};

}  // namespace rigor
