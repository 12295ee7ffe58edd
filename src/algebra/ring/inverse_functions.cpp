// SPDX-License-Identifier: GPL-3.0-or-later
// Logarithms, powers with any exponent, arcs, and what is known of π: the part of Functions that turns sin,
// cos and exp back.
#include <cln/integer.h>
#include <ginac/ginac.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include "algebra/engine/terms.h"
#include "algebra/engine/undecidable.h"
#include "algebra/ring/division.h"
#include "algebra/ring/functions.h"

namespace rigor {
namespace {

using GiNaC::ex;

constexpr long largest_prime = 1000;  // that is looked for in a number

[[nodiscard]] Rational rational_in(const ex& number) {
  return cln::the<Rational>(GiNaC::ex_to<GiNaC::numeric>(number).to_cl_N());
}

/// Its factors with their exponents, where it is small enough to look for them.
[[nodiscard]] ex factored(const ex& expanded) {
  if (!GiNaC::is_a<GiNaC::add>(expanded) || !may_be_factored(expanded)) return expanded;
  return GiNaC::factor(expanded);
}

}  // namespace

Fraction Functions::circle_number() {
  if (circle_.is_zero()) {
    circle_ = indeterminates_.fresh(Indeterminates::Kind::function, common_frame);
    signs_.know(circle_, Sign::positive);
  }
  return polynomial(circle_);
}

std::vector<ex> Functions::never_zero() const {
  std::vector<ex> all;
  if (!circle_.is_zero()) all.push_back(circle_);
  for (const auto& [quantity, functions] : quantities_) {
    if (!functions.exponential.is_zero()) all.push_back(functions.exponential);
  }
  std::ranges::sort(all, {}, [&](const ex& each) { return indeterminates_.origin(each).position; });
  return all;
}

Fraction Functions::scaled(Fraction value, const Rational& factor) {
  return arithmetic_.multiply(value, to_fraction(factor));
}

Fraction Functions::twelfths_of_circle(int count) { return scaled(circle_number(), Rational(count) / 12); }

/// A quotient of polynomials as GiNaC holds it.
Fraction Functions::fraction_of(const ex& value) {
  Fraction result = to_fraction(1);
  for (const ex& factor : factors_of(value)) {
    const auto [base, exponent] = split_power(factor);
    result = arithmetic_.multiply(result, arithmetic_.power(polynomial(base.expand()), exponent));
  }
  return result;
}

// --- angles

/// cos and sin of 15°, 30°, … by those of the first three.
Functions::Direction Functions::direction_of_twelfths(int count) {
  const int quarter = ((count % 24) + 24) % 24 / 6;
  const int within = ((count % 24) + 24) % 6;
  const auto root = [&](int square) { return radicals_.root(to_fraction(square)); };
  const auto over = [&](Fraction above, int below) { return scaled(std::move(above), Rational(1) / below); };
  const auto quarter_of_roots = [&](int sign) {  // (√6 ± √2)/4
    Fraction sum = root(6);
    arithmetic_.add(sum, scaled(root(2), sign));
    return over(std::move(sum), 4);
  };
  const auto cosine = [&](int twelfths) -> Fraction {
    switch (twelfths) {
      case 0:
        return to_fraction(1);
      case 1:
        return quarter_of_roots(1);
      case 2:
        return over(root(3), 2);
      case 3:
        return over(root(2), 2);
      case 4:
        return over(to_fraction(1), 2);
      case 5:
        return quarter_of_roots(-1);
      default:
        return {};
    }
  };
  Direction direction{cosine(within), cosine(6 - within)};
  for (int turn = 0; turn < quarter; ++turn) {
    arithmetic_.negate(direction.sine);
    std::swap(direction.cosine, direction.sine);
  }
  return direction;
}

/// sin and cos of arctan u and of arcsin u.
Functions::Direction Functions::direction_of(const Value& angle) {
  const Fraction u = fraction_of(angle.argument);
  Fraction square = arithmetic_.multiply(u, u);
  const bool tangent = angle.function == Function::arctan;
  if (!tangent) arithmetic_.negate(square);
  arithmetic_.add(square, to_fraction(1));
  const Fraction root = radicals_.root(square);
  if (!tangent) return {root, u};
  Fraction cosine = arithmetic_.reciprocal(root);
  radicals_.rationalize(cosine);
  return {cosine, arithmetic_.multiply(u, cosine)};
}

/// At 0, ±1 and the roots that belong to multiples of π/12.
std::optional<Fraction> Functions::known_arc(Function function, const Fraction& argument) {
  if (argument.numerator.is_zero()) return Fraction{};
  Fraction square = arithmetic_.multiply(argument, argument);
  simplify(square);
  if (!is_number(square.numerator) || !square.divisors.empty()) return std::nullopt;
  const Rational value = rational_in(square.numerator);
  const std::array<std::pair<Rational, int>, 4> of_sine{
      {{Rational(1) / 4, 2}, {Rational(1) / 2, 3}, {Rational(3) / 4, 4}, {Rational(1), 6}}};
  const std::array<std::pair<Rational, int>, 3> of_tangent{
      {{Rational(1) / 3, 2}, {Rational(1), 3}, {Rational(3), 4}}};
  const auto found = [&](const auto& table) -> std::optional<Fraction> {
    for (const auto& [number, twelfths] : table) {
      if (number != value) continue;
      const Sign sign = signs_.of(argument);
      if (sign == Sign::positive) return twelfths_of_circle(twelfths);
      if (sign == Sign::negative) return twelfths_of_circle(-twelfths);
    }
    return std::nullopt;
  };
  return function == Function::arcsin ? found(of_sine) : found(of_tangent);
}

Fraction Functions::arc(Function function, Fraction argument) {
  simplify(argument);
  if (auto known = known_arc(function, argument)) return *std::move(known);
  ex quotient = argument.numerator;
  for (const Divisor& each : argument.divisors) quotient /= GiNaC::pow(each.base, each.exponent);
  if (may_be_factored(argument.numerator)) quotient = quotient.normal();
  const bool negative = indeterminates_.unsigned_fingerprint(quotient).negative;  // arcs are odd
  const Fraction angle = polynomial(value_named(function, negative ? -quotient : quotient).symbol);
  return negative ? scaled(angle, -1) : angle;
}

// --- logarithms and powers

const Functions::Value& Functions::value_named(Function function, const ex& argument) {
  for (const Value& known : values_) {
    if (known.function == function && (known.argument - argument).expand().is_zero()) return known;
  }
  const FrameSet frames = indeterminates_.frames_of(argument);
  values_.push_back({function, argument, indeterminates_.fresh(Indeterminates::Kind::function, frames)});
  return values_.back();
}

const Functions::Value* Functions::value_of_symbol(const ex& symbol) const {
  const auto found = std::ranges::find_if(values_, [&](const Value& v) { return v.symbol.is_equal(symbol); });
  return found == values_.end() ? nullptr : &*found;
}

/// exp(count/d · ln|f|): |f| to a whole or half power, times an exponential for what is left.
Fraction Functions::power_of_argument(const Value& logarithm, int count) {
  const Rational exponent = Rational(count) / divisor_;
  const Fraction base = polynomial(logarithm.argument);
  const bool positive = signs_.of(base) == Sign::positive;
  const Fraction size = positive ? base : radicals_.root(arithmetic_.power(base, 2));
  if (cln::denominator(exponent) == 2)
    return arithmetic_.power(radicals_.root(size), static_cast<int>(cln::double_approx(2 * exponent)));
  const cln::cl_I whole = cln::floor1(exponent);
  const Fraction power = arithmetic_.power(size, cln::cl_I_to_int(whole));
  const Rational rest = (exponent - whole) * divisor_;
  if (cln::zerop(rest)) return power;
  return arithmetic_.multiply(power,
                              base_power(logarithm.symbol, static_cast<int>(cln::double_approx(rest))));
}

/// What has a logarithm is positive: entered where the value is one factor, to an odd power.
void Functions::note_positive(const Fraction& value) {
  std::optional<ex> odd;
  bool negative = false;
  const auto note = [&](const ex& factor, int exponent) {
    if (exponent % 2 == 0) return true;
    if (is_number(factor)) {
      negative = negative != cln::minusp(rational_in(factor));
      return true;
    }
    if (signs_.of(factor) == Sign::positive) return true;
    if (odd) return false;
    odd = factor;
    return true;
  };
  for (const ex& factor : factors_of(value.numerator)) {
    const auto [base, exponent] = split_power(factor);
    if (!note(base, exponent)) return;
  }
  for (const Divisor& each : value.divisors) {
    if (!note(each.base, each.exponent)) return;
  }
  if (!odd) return;
  if (GiNaC::is_a<GiNaC::symbol>(*odd)) {
    signs_.know(*odd, negative ? Sign::negative : Sign::positive);
  } else {
    signs_.add_fact((negative ? -*odd : *odd).expand(), Sign::positive);
  }
}

Fraction Functions::logarithm(Fraction argument) {
  simplify(argument);
  if (argument.numerator.is_zero()) throw NoRealValue("a logarithm of 0");
  if (is_within(signs_.of(argument), Sign::not_positive))
    throw NoRealValue("a logarithm of a number that is not positive");
  note_positive(argument);
  Fraction total = logarithm_of_polynomial(argument.numerator);
  for (const Divisor& each : argument.divisors)
    arithmetic_.add(total, scaled(logarithm_of_polynomial(each.base), -each.exponent));
  return total;
}

/// ln|p|.
Fraction Functions::logarithm_of_polynomial(const ex& expanded) {
  Fraction total;
  for (const ex& factor : factors_of(factored(expanded))) {
    const auto [base, exponent] = split_power(factor);
    if (is_number(base)) {
      arithmetic_.add(total, scaled(logarithm_of_number(cln::abs(rational_in(base))), exponent));
      continue;
    }
    const GiNaC::numeric content = base.integer_content();
    arithmetic_.add(total, scaled(logarithm_of_number(rational_in(content)), exponent));
    arithmetic_.add(total, scaled(logarithm_of_factor((base / content).expand()), exponent));
  }
  return total;
}

Fraction Functions::logarithm_of_factor(const ex& factor) {
  if (is_number(factor)) return logarithm_of_number(cln::abs(rational_in(factor)));
  for (const auto& [quantity, functions] : quantities_) {
    if (functions.exponential.is_equal(factor)) return scaled(fraction_of(quantity), Rational(1) / divisor_);
  }
  for (const auto& [symbol, square] : radicals_.roots()) {
    if (symbol.is_equal(factor)) return scaled(logarithm_of_polynomial(square), Rational(1) / 2);
  }
  const bool negative = indeterminates_.unsigned_fingerprint(factor).negative;
  return polynomial(value_named(Function::log, negative ? (-factor).expand() : factor).symbol);
}

Fraction Functions::logarithm_of_number(const Rational& positive) {
  Fraction total;
  const auto add_factors = [&](cln::cl_I whole, int sign) {
    for (long prime = 2; prime <= largest_prime && whole > 1; ++prime) {
      int exponent = 0;
      while (cln::zerop(cln::mod(whole, prime))) {
        whole = cln::exquo(whole, prime);
        ++exponent;
      }
      if (exponent == 0) continue;
      const ex symbol = value_named(Function::log, static_cast<int>(prime)).symbol;
      signs_.know(symbol, Sign::positive);
      arithmetic_.add(total, scaled(polynomial(symbol), sign * exponent));
    }
    if (whole == 1) return;
    const ex symbol = value_named(Function::log, GiNaC::numeric(whole)).symbol;
    signs_.know(symbol, Sign::positive);
    arithmetic_.add(total, scaled(polynomial(symbol), sign));
  };
  add_factors(cln::numerator(positive), 1);
  add_factors(cln::denominator(positive), -1);
  return total;
}

/// A whole exponent needs no logarithm; any other one needs a positive base.
Fraction Functions::real_power(const Fraction& base, const Fraction& exponent) {
  Fraction simple = exponent;
  simplify(simple);
  if (simple.numerator.is_zero()) return to_fraction(1);
  if (is_number(simple.numerator) && simple.divisors.empty()) {
    const Rational number = rational_in(simple.numerator);
    if (cln::denominator(number) == 1 && cln::abs(number) <= largest_exponent)
      return arithmetic_.power(base, static_cast<int>(cln::double_approx(number)));
  }
  const Fraction argument = arithmetic_.multiply(simple, logarithm(base));
  return exponential(taken_apart(argument, false).multiples);
}

}  // namespace rigor
