// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/engine/enclosure.h"

#include <string_view>

#include "algebra/engine/undecidable.h"
#include "catch.h"

using namespace rigor;

namespace {

[[nodiscard]] Enclosure exactly(const Rational& value) { return {value, value}; }

/// Do the bounds lie around the number with these decimals, and hardly apart?
[[nodiscard]] bool surrounds(const Enclosure& value, const std::string& decimals) {
  const Rational number = from_digits(decimals);
  const Rational last = Rational(1) / power_of(10, 30);
  return value.low <= number + last && number - last <= value.high && value.high - value.low < last;
}

}  // namespace

TEST_CASE("functions and roots are enclosed to thirty digits", "[algebra]") {
  CHECK(surrounds(circle_number(), "3.141592653589793238462643383279503"));
  CHECK(surrounds(root(exactly(2)), "1.414213562373095048801688724209698"));
  CHECK(surrounds(applied(Function::exp, exactly(1)), "2.718281828459045235360287471352662"));
  CHECK(surrounds(applied(Function::log, exactly(2)), "0.693147180559945309417232121458177"));
  CHECK(surrounds(applied(Function::sin, exactly(1)), "0.841470984807896506652502321630299"));
  CHECK(surrounds(applied(Function::cos, exactly(1)), "0.540302305868139717400936607442977"));
  CHECK(surrounds(applied(Function::arctan, exactly(1)), "0.785398163397448309615660845819876"));
  CHECK(
      surrounds(applied(Function::arcsin, exactly(Rational(1) / 2)), "0.523598775598298873077107230546584"));
  CHECK(
      surrounds(applied(Function::arccos, exactly(Rational(1) / 2)), "1.047197551196597746154214461093168"));
}

TEST_CASE("an enclosure holds what its operands may be", "[algebra]") {
  const Enclosure about_zero{-1, 2};
  CHECK(power(about_zero, 2).low == 0);
  CHECK(power(about_zero, 2).high == 4);
  CHECK(power(about_zero, 3).low == -1);
  CHECK(product(about_zero, exactly(-3)).low == -6);
  CHECK(product(about_zero, exactly(-3)).high == 3);
  CHECK(applied(Function::sin, about_zero).low <= -1);
  CHECK(applied(Function::exp, about_zero).high > 7);
  CHECK_THROWS_AS(quotient(exactly(1), about_zero), PointRejected);
  CHECK_THROWS_AS(root(about_zero), PointRejected);
  CHECK_THROWS_AS(applied(Function::log, about_zero), PointRejected);
  CHECK_THROWS_AS(applied(Function::arcsin, about_zero), PointRejected);
}

TEST_CASE("an enclosure is printed with six digits", "[algebra]") {
  CHECK(to_text(circle_number()) == "3.14159");
  CHECK(to_text(root(exactly(5))) == "2.23607");
  CHECK(to_text(opposite(applied(Function::log, exactly(2)))) == "-0.693147");
  CHECK(to_text(product(circle_number(), exactly(1'000'000))) == "3141592.7");
  CHECK(to_text(quotient(circle_number(), exactly(1000))) == "0.00314159");
  CHECK(to_text(sum(circle_number(), opposite(circle_number()))) == "0.000000");
}
