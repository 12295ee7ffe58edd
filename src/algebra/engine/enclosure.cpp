// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/engine/enclosure.h"

#include <cln/float.h>
#include <cln/integer.h>
#include <cln/real.h>

#include <algorithm>
#include <array>

#include "algebra/engine/undecidable.h"

namespace rigor {
namespace {

constexpr int function_digits = 80;  // decimal, that CLN computes with
constexpr int trusted_bits = 160;    // of the 265 that these are
constexpr int largest_argument = 2'000;
constexpr int shown_digits = 6;
constexpr int most_decimals = 60;

/// The largest number of `enclosure_bits` binary digits that is not above the value.
[[nodiscard]] Rational rounded_down(const Rational& value) {
  if (cln::zerop(value)) return value;
  const auto size = static_cast<long>(cln::integer_length(cln::numerator(value))) -
                    static_cast<long>(cln::integer_length(cln::denominator(value)));
  const long shift = enclosure_bits - size;
  const cln::cl_I unit = cln::ash(1, std::abs(shift));
  const Rational scaled = shift >= 0 ? value * unit : value / unit;
  const Rational whole = cln::floor1(scaled);
  return shift >= 0 ? whole / unit : whole * unit;
}

[[nodiscard]] Enclosure outward(const Rational& low, const Rational& high) {
  return {rounded_down(low), -rounded_down(-high)};
}

[[nodiscard]] cln::cl_F approximate(const Rational& value) {
  return cln::cl_float(value, cln::float_format(function_digits));
}

/// Around what CLN computed.
[[nodiscard]] Enclosure widened(const cln::cl_R& computed) {
  const Rational value = cln::rational(computed);
  const Rational margin =
      (cln::abs(value) + Rational(1) / cln::ash(1, trusted_bits)) / cln::ash(1, trusted_bits);
  return outward(value - margin, value + margin);
}

/// Of a function that rises.
template <class Compute>
[[nodiscard]] Enclosure of_rising(const Enclosure& argument, const Compute& compute) {
  return {widened(compute(argument.low)).low, widened(compute(argument.high)).high};
}

/// Of sin or cos, which change by no more than their argument.
template <class Compute>
[[nodiscard]] Enclosure of_wave(const Enclosure& argument, const Compute& compute) {
  const Rational width = argument.high - argument.low;
  const Enclosure at = widened(compute(approximate(argument.low)));
  return outward(std::max<Rational>(at.low - width, -1), std::min<Rational>(at.high + width, 1));
}

[[nodiscard]] Enclosure arc_tangent(const Enclosure& argument) {
  return of_rising(argument, [](const Rational& x) { return cln::atan(approximate(x)); });
}

/// arcsin x = arctan(x/√(1 − x²)).
[[nodiscard]] Enclosure arc_sine(const Enclosure& argument) {
  if (argument.low <= -1 || argument.high >= 1)
    throw PointRejected("an arc sine of a number that may not be between -1 and 1");
  const Enclosure one{1, 1};
  const Enclosure cosine = root(sum(one, opposite(power(argument, 2))));
  return arc_tangent(quotient(argument, cosine));
}

}  // namespace

Enclosure sum(const Enclosure& a, const Enclosure& b) { return outward(a.low + b.low, a.high + b.high); }

Enclosure opposite(const Enclosure& value) { return {-value.high, -value.low}; }

Enclosure product(const Enclosure& a, const Enclosure& b) {
  const std::array<Rational, 4> all{a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
  return outward(*std::min_element(all.begin(), all.end()), *std::max_element(all.begin(), all.end()));
}

Enclosure quotient(const Enclosure& a, const Enclosure& b) {
  if (!cln::plusp(b.low) && !cln::minusp(b.high)) throw PointRejected("a division by what may be 0");
  return product(a, {1 / b.high, 1 / b.low});
}

Enclosure power(const Enclosure& base, int exponent) {
  if (exponent < 0) return quotient({1, 1}, power(base, -exponent));
  const Rational low = power_of(base.low, exponent);
  const Rational high = power_of(base.high, exponent);
  if (exponent % 2 != 0 || !cln::minusp(base.low)) return outward(low, high);
  if (!cln::plusp(base.high)) return outward(high, low);
  return outward(0, std::max(low, high));
}

Enclosure root(const Enclosure& square) {
  if (cln::minusp(square.low)) throw PointRejected("a root of what may be negative");
  return of_rising(square, [](const Rational& x) { return cln::sqrt(approximate(x)); });
}

Enclosure applied(Function function, const Enclosure& argument) {
  if (argument.low < -largest_argument || argument.high > largest_argument)
    throw PointRejected("a function of a number that is too large");
  switch (function) {
    case Function::sin:
      return of_wave(argument, [](const cln::cl_F& x) { return cln::sin(x); });
    case Function::cos:
      return of_wave(argument, [](const cln::cl_F& x) { return cln::cos(x); });
    case Function::exp:
      return of_rising(argument, [](const Rational& x) { return cln::exp(approximate(x)); });
    case Function::log:
      if (!cln::plusp(argument.low)) throw PointRejected("a logarithm of what may not be positive");
      return of_rising(argument, [](const Rational& x) { return cln::ln(approximate(x)); });
    case Function::arcsin:
      return arc_sine(argument);
    case Function::arccos: {
      const Enclosure circle = circle_number();
      return sum({circle.low / 2, circle.high / 2}, opposite(arc_sine(argument)));
    }
    case Function::arctan:
      return arc_tangent(argument);
  }
  throw PointRejected("a function that is not evaluated");
}

Enclosure circle_number() { return widened(cln::pi(cln::float_format(function_digits))); }

std::string to_text(const Enclosure& value) {
  const Rational middle = (value.low + value.high) / 2;
  const bool may_be_zero = !cln::plusp(value.low) && !cln::minusp(value.high);
  const Rational size = may_be_zero ? Rational(0) : cln::abs(middle);
  int decimals = shown_digits;
  for (Rational scale = 1; decimals > 1 && scale <= size; scale = scale * 10) --decimals;
  for (Rational scale = Rational(1) / 10; !may_be_zero && decimals < most_decimals && scale > size;
       scale = scale / 10)
    ++decimals;
  std::string digits = to_text(Rational(cln::round1(size * power_of(10, decimals))));
  const auto places = static_cast<std::size_t>(decimals);
  if (digits.size() <= places) digits.insert(0, places + 1 - digits.size(), '0');
  digits.insert(digits.size() - places, ".");
  return cln::minusp(middle) ? "-" + digits : digits;
}

}  // namespace rigor
