// SPDX-License-Identifier: GPL-3.0-or-later
// Square roots at the generic point. Each distinct radicand R has one indeterminate s ≥ 0 with s² = R.
// Method: √ of a product is split as far as that holds for all real values: √(f² g) = |f| √g; √(f g) = √f √g
// if f is never negative by the signs of its terms, or by an assumption; numbers give up their square
// factors. What vanishes modulo the relations s² = R vanishes for either sign of each root: sound. Complete
// only where the radicals are independent: radicands are compared after expansion but not factored.
#pragma once

#include <utility>
#include <vector>

#include "algebra/ring/fraction.h"
#include "algebra/ring/signs.h"

namespace rigor {

/// Effort::plain: a radicand is split only as it is written; factored: repeated factors of an expanded one
/// are found too.
class Radicals {
 public:
  Radicals(Indeterminates& indeterminates, FractionArithmetic& arithmetic, Signs& signs, Effort effort)
      : indeterminates_(indeterminates), arithmetic_(arithmetic), signs_(signs), effort_(effort) {}

  /// The non-negative root of a value; throws Undecidable if the value is a negative number.
  [[nodiscard]] Fraction root(const Fraction& square);

  /// The indeterminates s with their squares, in order of creation: a square has only earlier ones in it.
  [[nodiscard]] std::vector<std::pair<GiNaC::ex, GiNaC::ex>> roots() const;

  /// The same of all indeterminates whose square is replaced, roots or not.
  [[nodiscard]] std::vector<std::pair<GiNaC::ex, GiNaC::ex>> relations() const;

  /// From now on another indeterminate's square is replaced, too: it may be negative.
  void relate(const GiNaC::ex& symbol, const GiNaC::ex& square);

  /// An expanded polynomial with s² replaced by R as often as it occurs, expanded again.
  [[nodiscard]] Numerator reduced(const Numerator& expanded);

  /// 1/s as s/R: one form for |r|^-3 and |r|/r⁴.
  void rationalize(Fraction& value);

  /// What follows from an equation a·s + b = 0 with a single radical s: b² − a² R, expanded. 0 for any other.
  [[nodiscard]] GiNaC::ex squared(const GiNaC::ex& equation);

  /// The same expression of another particle.
  [[nodiscard]] GiNaC::ex moved(const GiNaC::ex& value, Frame from, Frame to);

  [[nodiscard]] bool any() const { return any_root_; }
  [[nodiscard]] bool is_radical(const GiNaC::ex& indeterminate) const;

 private:
  struct Radical {
    GiNaC::ex symbol;
    Numerator square;  // expanded; has only earlier radicals in it
    bool root = true;  // never negative
  };
  struct Factor {
    GiNaC::ex base;  // expanded
    int exponent = 1;
  };

  [[nodiscard]] Fraction radical(const GiNaC::ex& square);
  [[nodiscard]] Fraction root_of_number(const Rational& value);
  [[nodiscard]] Fraction absolute(const GiNaC::ex& value);
  /// In an order that is the same in every run: new radicals are made in it.
  [[nodiscard]] std::vector<Factor> factors(const Fraction& value);
  void note_factors(std::vector<Factor>& found, GiNaC::ex value, int exponent,
                    const std::vector<Divisor>& known);
  static void note(std::vector<Factor>& found, const GiNaC::ex& base, int exponent);
  void note_existence(const std::vector<Factor>& square);
  [[nodiscard]] Sign sign_of(const GiNaC::ex& expanded) const;
  [[nodiscard]] bool never_negative(const GiNaC::ex& expanded) const {
    return is_within(sign_of(expanded), Sign::not_negative);
  }

  Indeterminates& indeterminates_;
  FractionArithmetic& arithmetic_;
  Signs& signs_;
  Effort effort_;
  std::vector<Radical> radicals_;
  bool any_root_ = false;
};

}  // namespace rigor
