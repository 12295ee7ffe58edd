// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/ring/functions.h"

#include <ginac/ginac.h>

#include <cstdlib>
#include <string>

#include "algebra/engine/terms.h"
#include "algebra/engine/undecidable.h"

namespace rigor {
namespace {

using GiNaC::ex;

constexpr std::size_t largest_argument = 12;  // terms

}  // namespace

/// Roots out of the denominator, the numerator expanded and reduced.
void Functions::simplify(Fraction& value) {
  radicals_.rationalize(value);
  arithmetic_.expand(value);
  value.numerator = radicals_.reduced(value.numerator);
}

Functions::Argument Functions::taken_apart(Fraction argument, bool angle) {
  simplify(argument);
  const ex numerator = argument.numerator;
  if (numerator.is_zero()) return {};
  if (term_count(numerator) > largest_argument) throw Undecidable("a function's argument has too many terms");
  ex divisor = 1;
  for (const Divisor& each : argument.divisors) divisor *= GiNaC::pow(each.base, each.exponent);
  Argument parts;
  std::map<std::string, Multiple> in_order;
  for (const ex& term : terms_of(numerator)) {
    const GiNaC::numeric coefficient = coefficient_of(term);
    const ex quantity = term / coefficient / divisor;
    if (angle && quantity.is_equal(circle_) && (12 * coefficient).is_integer()) {
      parts.twelfths = GiNaC::mod(12 * coefficient, 24).to_int();
      continue;
    }
    const GiNaC::numeric count = coefficient * divisor_;
    if (!count.is_integer()) {
      const GiNaC::numeric finer = GiNaC::lcm(coefficient.denom(), divisor_);
      if (finer > largest_multiple)
        throw Undecidable("a function's argument has a fraction with too large a denominator");
      throw FinerAngles(finer.to_int());
    }
    if (GiNaC::abs(count) > largest_multiple * divisor_) {
      throw Undecidable("a function's argument has too large a multiple");
    }
    in_order.emplace(indeterminates_.fingerprint(quantity), Multiple{quantity, count.to_int()});
  }
  for (const auto& [fingerprint, multiple] : in_order) parts.multiples.push_back(multiple);
  return parts;
}

/// cos nφ = T_n(cos φ) and sin nφ = sin φ U_{n−1}(cos φ): f_{n+1} = 2 cos φ f_n − f_{n−1}.
Functions::Direction Functions::direction(const Multiple& of) {
  const Value* angle = divisor_ == 1 ? value_of_symbol(of.quantity) : nullptr;
  if (angle != nullptr && angle->function != Function::log) {
    const Direction once = direction_of(*angle);
    Direction total{to_fraction(1), Fraction{}};
    for (int n = 0; n < std::abs(of.count); ++n) total = turned(total, once);
    if (of.count < 0) arithmetic_.negate(total.sine);
    return total;
  }
  Quantity& base = quantities_[of.quantity];
  if (base.cosine.is_zero()) {
    const FrameSet frames = indeterminates_.frames_of(of.quantity);
    base.cosine = indeterminates_.fresh(Indeterminates::Kind::function, frames);
    base.sine = indeterminates_.fresh(Indeterminates::Kind::function, frames);
    radicals_.relate(base.sine, 1 - base.cosine * base.cosine);
    signs_.add_fact(1 - base.cosine * base.cosine, Sign::not_negative);
  }
  ex cosine_before = 1;
  ex sine_before = 0;
  ex cosine = base.cosine;
  ex sine = 1;
  for (int n = 1; n < std::abs(of.count); ++n) {
    const ex cosine_next = (2 * base.cosine * cosine - cosine_before).expand();
    const ex sine_next = (2 * base.cosine * sine - sine_before).expand();
    cosine_before = cosine;
    sine_before = sine;
    cosine = cosine_next;
    sine = sine_next;
  }
  const int sign = of.count < 0 ? -1 : 1;
  return {polynomial(cosine), polynomial((sign * base.sine * sine).expand())};
}

Functions::Direction Functions::turned(const Direction& a, const Direction& b) {
  Direction sum{arithmetic_.multiply(a.cosine, b.cosine), arithmetic_.multiply(a.sine, b.cosine)};
  Fraction subtracted = arithmetic_.multiply(a.sine, b.sine);
  arithmetic_.negate(subtracted);
  arithmetic_.add(sum.cosine, subtracted);
  arithmetic_.add(sum.sine, arithmetic_.multiply(a.cosine, b.sine));
  return sum;
}

/// exp(count Q/d).
Fraction Functions::base_power(const ex& quantity, int count) {
  ex& base = quantities_[quantity].exponential;
  if (base.is_zero()) {
    base = indeterminates_.fresh(Indeterminates::Kind::function, indeterminates_.frames_of(quantity));
    signs_.know(base, Sign::positive);
  }
  return arithmetic_.power(polynomial(base), count);
}

Fraction Functions::exponential(const std::vector<Multiple>& multiples) {
  Fraction product = to_fraction(1);
  for (const Multiple& each : multiples) {
    const Value* value = value_of_symbol(each.quantity);
    const bool of_logarithm = value != nullptr && value->function == Function::log;
    product = arithmetic_.multiply(product, of_logarithm ? power_of_argument(*value, each.count)
                                                         : base_power(each.quantity, each.count));
  }
  return product;
}

Fraction Functions::angle_function(Function function, Fraction argument) {
  const Argument parts = taken_apart(std::move(argument), true);
  Direction total = direction_of_twelfths(parts.twelfths);
  for (const Multiple& each : parts.multiples) total = turned(total, direction(each));
  return function == Function::cos ? total.cosine : total.sine;
}

Fraction Functions::value(Function function, Fraction argument) {
  switch (function) {
    case Function::sin:
    case Function::cos:
      return angle_function(function, std::move(argument));
    case Function::exp:
      return exponential(taken_apart(std::move(argument), false).multiples);
    case Function::log:
      return logarithm(std::move(argument));
    case Function::arcsin:
    case Function::arctan:
      return arc(function, std::move(argument));
    case Function::arccos: {
      Fraction angle = arc(Function::arcsin, std::move(argument));
      arithmetic_.negate(angle);
      arithmetic_.add(angle, twelfths_of_circle(6));
      return angle;
    }
  }
  throw Undecidable("a function that is not decided");
}

}  // namespace rigor
