// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/lane/double_double.h"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "base/splitmix.h"
#include "catch.h"
#include "numeric/program/uniform.h"

namespace rigor {
namespace {

using Number = baseline::DoubleDouble<double>;
/// Sums and products of two numbers below are exact in it.
using Reference = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>>;

constexpr double v = 0x1p-106;
constexpr int draws = 20'000;

Reference exact(const Number& x) { return Reference(x.high) + x.low; }

/// Operands of any sign, of like size and of sizes up to 2^±60 apart, and those that nearly cancel.
class NumberDraw {
 public:
  explicit NumberDraw(std::uint64_t seed) : bits_(seed) {}

  Number next() {
    const double high = std::ldexp(uniform_sign(bits_), static_cast<int>(60 * uniform_sign(bits_)));
    const double low = high * 0x1p-53 * uniform_sign(bits_);
    return baseline::normalised(high, low * std::ldexp(1.0, static_cast<int>(-20 * uniform(bits_))));
  }
  /// −x but for some of its last bits.
  Number nearly_minus(const Number& x) {
    const double rest = std::ldexp(uniform_sign(bits_), static_cast<int>(-110 * uniform(bits_)));
    const Reference value = -exact(x) * (1 + Reference(rest));
    const auto high = static_cast<double>(value);
    return {high, static_cast<double>(Reference(value - high))};
  }

 private:
  SplitMix bits_;
};

/// In v, relative; 0 for what is exactly 0.
double error_in_v(const Number& x, const Reference& value) {
  const Reference error = abs(exact(x) - value);
  return error == 0 ? 0 : static_cast<double>(Reference(error / abs(value))) / v;
}

bool is_normalised(const Number& x) { return x.high + x.low == x.high; }

/// The greatest error of an operation on two numbers, of like signs, unlike signs and cancelling.
template <class Operation, class Exact>
double worst_of(const Operation& operation, const Exact& exactly) {
  NumberDraw draw(51);
  double worst = 0;
  for (int k = 0; k < draws; ++k) {
    const Number a = draw.next();
    for (const Number& b : {draw.next(), draw.nearly_minus(a)}) {
      const Number result = operation(a, b);
      if (!is_normalised(result)) return INFINITY;
      worst = std::max(worst, error_in_v(result, exactly(exact(a), exact(b))));
    }
  }
  return worst;
}

TEST_CASE("the sum and the product of two numbers of one part are exact") {
  NumberDraw draw(52);
  for (int k = 0; k < draws; ++k) {
    const double a = draw.next().high;
    const double b = draw.next().high;
    for (const double second : {b, -std::nextafter(a, b), a}) {
      CHECK(exact(baseline::exact_sum(a, second)) == Reference(a) + second);
      CHECK(exact(baseline::exact_difference(a, second)) == Reference(a) - second);
      CHECK(exact(baseline::exact_product(a, second)) == Reference(a) * second);
    }
    const double great = std::max(std::abs(a), std::abs(b));
    const double small = std::min(std::abs(a), std::abs(b));
    CHECK(exact(baseline::normalised(great, -small)) == Reference(great) - small);
  }
}

TEST_CASE("operations on numbers of two parts meet their bounds") {
  const auto sum = [](const auto& a, const auto& b) { return a + b; };
  const auto difference = [](const auto& a, const auto& b) { return a - b; };
  const auto product = [](const auto& a, const auto& b) { return a * b; };
  const auto quotient = [](const auto& a, const auto& b) { return a / b; };
  const auto reference = [](const auto& operation) {
    return [operation](const Reference& a, const Reference& b) { return Reference(operation(a, b)); };
  };
  CHECK(worst_of(sum, reference(sum)) <= 3);
  CHECK(worst_of(difference, reference(difference)) <= 3);
  CHECK(worst_of(product, reference(product)) <= 7);
  CHECK(worst_of(quotient, reference(quotient)) <= 15);
}

TEST_CASE("operations with a number of one part meet their bounds") {
  NumberDraw draw(53);
  for (int k = 0; k < draws; ++k) {
    const Number a = draw.next();
    for (const double b : {draw.next().high, -a.high}) {
      CHECK(error_in_v(a + b, exact(a) + b) <= 2);
      CHECK(error_in_v(a * b, exact(a) * b) <= 3);
    }
  }
}

TEST_CASE("the root of a number of two parts meets its bound") {
  NumberDraw draw(54);
  for (int k = 0; k < draws; ++k) {
    Number a = draw.next();
    if (a.high < 0) a = -a;
    CHECK(error_in_v(baseline::root(a), sqrt(exact(a))) <= 4);
  }
  CHECK(baseline::root(Number{}).high == 0);
}

TEST_CASE("a sum that adds the low parts without care exceeds the bound where numbers cancel") {
  const auto sloppy = [](const Number& a, const Number& b) {
    const Number high = baseline::exact_sum(a.high, b.high);
    return baseline::normalised(high.high, high.low + (a.low + b.low));
  };
  CHECK(worst_of(sloppy, [](const Reference& a, const Reference& b) { return Reference(a + b); }) > 1e3);
}

TEST_CASE("a product without the crossed low parts exceeds the bound") {
  const auto crude = [](const Number& a, const Number& b) {
    const Number p = baseline::exact_product(a.high, b.high);
    return baseline::normalised(p.high, p.low + a.high * b.low);
  };
  CHECK(worst_of(crude, [](const Reference& a, const Reference& b) { return Reference(a * b); }) > 1e3);
}

}  // namespace
}  // namespace rigor
