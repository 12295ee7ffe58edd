// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/exact/long_sum.h"

#include <cmath>
#include <limits>

#include "base/splitmix.h"
#include "catch.h"
#include "numeric/program/uniform.h"

namespace rigor {
namespace {

using Rational = boost::multiprecision::cpp_rational;

Rational in_units(const LongSum& sum) {
  return Rational(sum.value()) / Rational(Integer(1) << -LongSum::lowest);
}

TEST_CASE("a long sum of products of any doubles is the rational number", "[exact]") {
  SplitMix bits(1);
  const auto number = [&] {
    return std::ldexp(uniform_sign(bits), static_cast<int>(bits.below(2098)) - 1074);
  };
  LongSum sum;
  Rational exact = 0;
  for (int n = 0; n < 300; ++n) {
    const double a = number();
    const double b = number();
    const double c = number();
    sum.add(dyadic(a), dyadic(b), dyadic(c));
    sum.add(dyadic(b), dyadic(c));
    sum.add(dyadic(c));
    exact += Rational(a) * Rational(b) * Rational(c) + Rational(b) * Rational(c) + Rational(c);
    if (n % 50 == 0) CHECK(in_units(sum) == exact);
  }
  CHECK(in_units(sum) == exact);
}

TEST_CASE("the greatest and the smallest products have room, and cancel", "[exact]") {
  const double most = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  LongSum sum;
  sum.add(dyadic(most), dyadic(most), dyadic(-most));
  sum.add(dyadic(least), dyadic(least), dyadic(least));
  const Rational m = most;
  const Rational l = least;
  CHECK(in_units(sum) == l * l * l - m * m * m);
  sum.add(dyadic(-most), dyadic(-most), dyadic(most));
  CHECK(in_units(sum) == l * l * l);
  sum.add(dyadic(0.0), dyadic(most), dyadic(most));
  sum.add(dyadic(-least), dyadic(-least), dyadic(-least));
  CHECK(sum.value() == 0);
}

TEST_CASE("a million terms of one sign carry nothing out of their place", "[exact]") {
  LongSum sum;
  const double x = 1 - 0x1p-53;
  for (int n = 0; n < 1'000'000; ++n) sum.add(dyadic(x), dyadic(-x), dyadic(x));
  const Rational each = x;
  CHECK(in_units(sum) == -1'000'000 * each * each * each);
}

}  // namespace
}  // namespace rigor
