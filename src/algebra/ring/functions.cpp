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

/// The argument's terms, in an order that is the same in every run.
std::vector<Functions::Multiple> Functions::multiples(Fraction argument) {
  radicals_.rationalize(argument);
  arithmetic_.expand(argument);
  const ex numerator = radicals_.reduced(argument.numerator);
  if (numerator.is_zero()) return {};
  if (term_count(numerator) > largest_argument) throw Undecidable("a function's argument has too many terms");
  ex divisor = 1;
  for (const Divisor& each : argument.divisors) divisor *= GiNaC::pow(each.base, each.exponent);
  std::map<std::string, Multiple> in_order;
  for (const ex& term : terms_of(numerator)) {
    const GiNaC::numeric coefficient = coefficient_of(term);
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
    const ex quantity = term / coefficient / divisor;
    in_order.emplace(indeterminates_.fingerprint(quantity), Multiple{quantity, count.to_int()});
  }
  std::vector<Multiple> all;
  for (const auto& [fingerprint, multiple] : in_order) all.push_back(multiple);
  return all;
}

/// cos nφ = T_n(cos φ) and sin nφ = sin φ U_{n−1}(cos φ): f_{n+1} = 2 cos φ f_n − f_{n−1}.
Functions::Direction Functions::direction(const Multiple& of) {
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

Fraction Functions::exponential(const std::vector<Multiple>& multiples) {
  Fraction product = to_fraction(1);
  for (const Multiple& each : multiples) {
    ex& base = quantities_[each.quantity].exponential;
    if (base.is_zero()) {
      base = indeterminates_.fresh(Indeterminates::Kind::function, indeterminates_.frames_of(each.quantity));
      signs_.know(base, Sign::positive);
    }
    product = arithmetic_.multiply(product, arithmetic_.power(polynomial(base), each.count));
  }
  return product;
}

Fraction Functions::value(Function function, Fraction argument) {
  const std::vector<Multiple> parts = multiples(std::move(argument));
  if (function == Function::exp) return exponential(parts);
  Direction total{to_fraction(1), Fraction{}};
  for (const Multiple& each : parts) total = turned(total, direction(each));
  return function == Function::cos ? total.cosine : total.sine;
}

}  // namespace rigor
