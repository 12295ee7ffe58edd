// SPDX-License-Identifier: GPL-3.0-or-later
// The elementary and elliptic functions of the kernels, against Boost's in 50 digits. The kernels of every
// instruction set give the same bits (torque_free_test.cpp): here those of the narrowest.
#include <boost/math/constants/constants.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>

#include "catch.h"
#include "numeric/lane/elliptic_lanes.h"
#include "numeric/lane/exact_terms.h"

namespace rigor {
namespace {

using Digits50 =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using TwoParts = baseline::DoubleDouble<double>;

constexpr double unit = 0x1p-53;

Digits50 value_of(TwoParts x) { return Digits50(x.high) + x.low; }
double error_of(const Digits50& found, const Digits50& expected) {
  return static_cast<double>(abs(found - expected) / abs(expected));
}

TEST_CASE("sine and cosine of half turns are right next to their zeros, and after 2^47 turns") {
  const Digits50 pi = boost::math::constants::pi<Digits50>();
  for (const double high :
       {0.1, -0.25, 0.25, 0.4999999, 0.5, -0.5, 0.75, 1., 1.3, -1.7, 12345.678, 1e14 + .5, 0x1p48 - .25}) {
    for (const double low : {0., 1e-17, -3e-17}) {
      INFO(high << " + " << low);
      const auto found = baseline::sine_cosine_of_half_turns(TwoParts{high, low});
      const Digits50 y = Digits50(high) + low;
      const Digits50 rest = (y - 2 * floor(y / 2)) * pi;
      if (y != floor(y)) CHECK(error_of(found.sine, sin(rest)) < 2 * unit);
      if (2 * y != floor(2 * y) || y == floor(y)) CHECK(error_of(found.cosine, cos(rest)) < 2 * unit);
    }
  }
  for (const double beyond : {0x1p48, -0x1p51, 0x1p51 + .5, 0x1p52, 1e300})
    CHECK(std::isnan(baseline::sine_cosine_of_half_turns(TwoParts{beyond, .1}).sine));
  CHECK(baseline::sine_cosine_of_half_turns(TwoParts{1, 0}).sine == 0);
  CHECK(baseline::sine_cosine_of_half_turns(TwoParts{0.5, 0}).cosine == 0);
}

TEST_CASE("decay is right in its factor and in its change, down to 1e-304") {
  for (const double high : {0., 1e-300, 1e-20, 1e-8, .1, .3465, .3466, 1., 30., 299.5, 699.9}) {
    const double low = high * 0x1p-55;
    INFO(high);
    const auto found = baseline::decay(TwoParts{high, low});
    const Digits50 w = Digits50(high) + low;
    CHECK(error_of(found.factor, exp(-w)) < 2 * unit);
    if (high == 0) CHECK(found.change == 0);
    if (high > 1e-200) CHECK(error_of(found.change, expm1(-w)) < 2 * unit);
  }
  CHECK(baseline::decay(TwoParts{1e9, 0}).factor == baseline::decay(TwoParts{700, 0}).factor);
}

TEST_CASE("angles and logarithms in two parts have 21 digits") {
  for (int k = -50; k <= 50; ++k) {
    const double angle = 0.0628 * k;
    const TwoParts x{std::cos(angle), 1e-18};
    const TwoParts y{std::sin(angle), -1e-18};
    const Digits50 expected = atan2(value_of(y), value_of(x)) / boost::math::constants::pi<Digits50>();
    CHECK(abs(value_of(baseline::half_turns_of(x, y)) - expected) < 1e-21);
    const TwoParts z{1 + std::ldexp(.37, 3 * k + 150), 1e-17};
    CHECK(abs(value_of(baseline::logarithm(z)) - log(value_of(z))) < 2e-21);
  }
  CHECK(baseline::logarithm(TwoParts{1, 0}).high == 0);
  CHECK(abs(value_of(baseline::logarithm(TwoParts{0x1p900, 0})) - log(Digits50(0x1p900))) < 1e-20);
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double beyond : {0x1p990, 0x1p1000, 0x1.8p1023, infinity}) {
    const Digits50 found = value_of(baseline::logarithm(TwoParts{beyond, 0}));
    CHECK(abs(found - log(Digits50(0x1p990))) < 1e-20);
  }
  CHECK(std::isnan(baseline::half_turns_of({0, 0}, {0, 0}).high));
  CHECK(std::isnan(baseline::half_turns_of({std::nan(""), 0}, {1, 0}).high));
  CHECK(std::isnan(baseline::half_turns_of({1, 0}, {std::nan(""), 0}).high));
}

TEST_CASE("quarter periods from the complementary modulus have 30 digits, where 1 − k² has none left") {
  for (const double b : {1., .999, .7, .5, .1, 1e-4, 1e-8, 1e-16, 1e-100, 1e-250}) {
    INFO(b);
    const Digits50 mean = value_of(baseline::mean_of(TwoParts{1, 0}, TwoParts{b, 0}));
    // R_F(0, k'², 1) = K by duplication, another algorithm.
    const Digits50 quarter = boost::math::ellint_rf(Digits50(0), Digits50(b) * b, Digits50(1));
    CHECK(error_of(boost::math::constants::half_pi<Digits50>() / mean, quarter) < 1e-29);
    if (b > 1e-8) continue;
    const double k = std::sqrt(1 - b * b);  // the textbook's
    CHECK((k == 1 || error_of(boost::math::ellint_1(k), quarter) > 100 * unit));
  }
}

TEST_CASE("phases from tan φ agree with Carlson's integral to 20 digits") {
  for (const double b : {.99, .7, .5, 1e-2}) {
    for (const double tangent : {1e-9, .1, 1., 7., 1e6}) {
      INFO(b << " " << tangent);
      const Digits50 square = Digits50(tangent) * tangent;
      const Digits50 cosine = 1 / (1 + square);
      const Digits50 delta = sqrt(cosine + square * cosine * b * b);
      // F(φ, k) = sin φ R_F(cos² φ, 1 − k² sin² φ, 1)
      const Digits50 f =
          sqrt(square * cosine) * boost::math::ellint_rf(cosine, Digits50(delta * delta), Digits50(1));
      const Digits50 v = f * value_of(baseline::mean_of(TwoParts{1, 0}, TwoParts{b, 0}));
      const double high = static_cast<double>(delta);
      const TwoParts two_parts{high, static_cast<double>(Digits50(delta - high))};
      const auto factors = baseline::descend(TwoParts{1, 0}, TwoParts{b, 0}, two_parts);
      CHECK(error_of(value_of(factors.tangent) * tangent, tan(v)) < 1e-20 * (1 + std::abs(tangent)));
      CHECK(error_of(value_of(factors.sine) * sqrt(square * cosine), sin(v)) < 1e-20);
    }
  }
}

TEST_CASE("the theta functions' polynomials are their series for every nome that is used") {
  for (const double q : {0., 1e-300, 1e-9, .02, .0858}) {
    double theta3[4];
    double theta2[4];
    baseline::theta_coefficients(q, theta3, theta2);
    for (const double v : {.1, .7, 1.5, 3.}) {
      Digits50 third = 1;
      Digits50 second = cos(Digits50(v));
      for (int n = 1; n < 8; ++n) {
        third += 2 * pow(Digits50(q), n * n) * cos(Digits50(2 * n * v));
        second += pow(Digits50(q), n * n + n) * cos(Digits50((2 * n + 1) * v));
      }
      const double g = 2 * q * std::cos(2 * v);
      CHECK(error_of(baseline::theta_at(theta3, g).plus, third) < 3 * unit);
      CHECK(error_of(std::cos(v) * baseline::theta_at(theta2, g).plus, second) < 4 * unit);
    }
  }
}

TEST_CASE("exact terms keep what cancels, and vanish only exactly") {
  baseline::ExactTerms terms;
  const double a = 1 + 0x1p-52;
  terms.add_product(a, {a, a * 0x1p-60}, {a, a * 0x1p-70}, 1);
  terms.add_product(a, {a, a * 0x1p-60}, {a, a * 0x1p-70}, -1);
  CHECK(terms.value().high == 0);
  terms.add(0x1p-300);
  CHECK(terms.value().high == 0x1p-300);
}

}  // namespace
}  // namespace rigor
