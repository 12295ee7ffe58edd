// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/run/run_bounded_decimal.h"

#include <random>
#include <vector>

#include "catch.h"

using namespace rigor;

namespace {

/// The same operation on numbers of any length.
template <class Number>
[[nodiscard]] Number applied(unsigned operation, const Number& x, const Number& y) {
  using Traits = NumberTraits<Number>;
  switch (operation) {
    case 0:
      return x + y;
    case 1:
      return x - y;
    case 2:
      return x * y;
    case 3:
      return x / y;
    case 4:
      return Traits::root(Traits::absolute(x));
    case 5:
      return Traits::sine(x) - y;
    case 6:
      return Traits::cosine(x);
    case 7:
      return Traits::exponential(x);
    case 8:
      return Traits::tangent(x);
    case 9:
      return Traits::hyperbolic_sine(x / Number(8.0));
    case 10:
      return Traits::hyperbolic_cosine(x) - y;
    default:
      return Traits::hyperbolic_tangent(x);
  }
}

}  // namespace

TEST_CASE("the bound of numbers with 20 digits holds, and is not absurdly large", "[numeric]") {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-2.0, 2.0);
  std::size_t known = 0;
  std::size_t sharp = 0;
  for (int run = 0; run < 300; ++run) {
    std::vector<BoundedDecimal<20>> few;
    std::vector<BoundedDecimal<400>> many;
    for (int i = 0; i < 4; ++i) {
      const double value = uniform(random);
      few.emplace_back(value);
      many.emplace_back(value);
    }
    for (int i = 0; i < 12; ++i) {
      const auto operation = static_cast<unsigned>(random() % 12);
      const std::size_t a = random() % few.size();
      const std::size_t b = random() % few.size();
      few.push_back(applied(operation, few[a], few[b]));
      many.push_back(applied(operation, many[a], many[b]));
      if (many.back().undefined || !few.back().bound.is_finite() || !many.back().is_known_to(200)) continue;
      ++known;
      const auto error = BoundedDecimal<400>::size_of(Decimal<400>(few.back().value) - many.back().value);
      CHECK_FALSE(few.back().bound < error);
      sharp += few.back().is_known_to(24) ? 1u : 0u;
    }
  }
  CHECK(known > 2000);
  CHECK(sharp > known * 90 / 100);
}

TEST_CASE("odd functions of tiny numbers are known to their digits", "[numeric]") {
  using Traits = NumberTraits<BoundedDecimal<100>>;
  const BoundedDecimal<100> tiny(1e-250);
  for (const auto& value : {Traits::sine(tiny), Traits::tangent(tiny), Traits::hyperbolic_sine(tiny),
                            Traits::hyperbolic_tangent(tiny)}) {
    CHECK(value.is_known_to(250));
    CHECK(abs(value.value / tiny.value - 1) < 1e-90);
  }
  CHECK(Traits::hyperbolic_tangent(BoundedDecimal<100>(1e5)).is_known_to(250));
  CHECK(Traits::hyperbolic_tangent(BoundedDecimal<100>(-1e5)).value < -0.9);
}

TEST_CASE("magnitudes neither overflow nor vanish, and are rounded upwards", "[numeric]") {
  Magnitude large(1e300);
  Magnitude small(1e-300);
  for (int i = 0; i < 10; ++i) {
    large = large * large;
    small = small * small;
  }
  CHECK(large.is_finite());
  CHECK_FALSE(small.is_zero());
  CHECK(Magnitude(0.999) < large * small);
  CHECK(large * small < Magnitude(1.001));
  CHECK(large < large + small);
  CHECK(Magnitude(1.0) < Magnitude(1.0) / Magnitude(3.0) * Magnitude(3.0 * (1.0 + 0x1p-40)));
  CHECK(Magnitude{} < small);
  CHECK(large < Magnitude::infinite());
  CHECK_FALSE((Magnitude(1.0) / Magnitude{}).is_finite());
  CHECK((Magnitude{} * Magnitude::infinite()).is_zero());
}
