// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/advice/expected_error.h"

#include <cmath>
#include <random>
#include <vector>

#include "catch.h"
#include "numeric/on_sample.h"

using namespace rigor;
using namespace rigor::build;

TEST_CASE("the expected error is that of the roundings, as far as it is not luck", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  const Program program = compiled(page, x * x - y * y);
  ErrorTape tape(program.code());
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(1, 2);
  double squares = 0;
  constexpr int count = 2000;
  for (int k = 0; k < count; ++k) {
    const double a = uniform(random);
    const double b = a * (1 + std::ldexp(uniform(random), -20));
    const ExpectedError expected = tape.at(std::vector{a, b});
    REQUIRE(expected.has_value);
    CHECK(expected.relative > 0x1p-36);
    CHECK(expected.relative < 0x1p-31);
    const double seen = tape.seen(tape);
    CHECK(seen < 4 * expected.relative);
    squares += (seen / expected.relative) * (seen / expected.relative);
  }
  // Roundings are spread evenly up to u: a third of its square.
  CHECK(squares / count > 0.02);
  CHECK(squares / count < 1);
}

TEST_CASE("what overflows on the way, or cancels altogether, has no right digit", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  const Program of_product = compiled(page, x * x / y);
  ErrorTape product(of_product.code());
  CHECK(product.at(std::vector{1e200, 1e300}).relative == 1);
  CHECK(product.at(std::vector{1e100, 1e300}).relative < 1e-15);
  const Program of_difference = compiled(page, (x + y) - x);
  ErrorTape difference(of_difference.code());
  CHECK(difference.at(std::vector{1.0, 1e-25}).relative == 1);
  CHECK(difference.at(std::vector{1.0, 1e-8}).relative < 1e-7);
}

TEST_CASE("a root of what is negative is no loss, unless rounding made it negative", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  const Program of_root = compiled(page, root(x - y));
  ErrorTape tape(of_root.code());
  CHECK(tape.at(std::vector{1.0, 2.0}).outside);
  CHECK_FALSE(tape.at(std::vector{2.0, 1.0}).outside);
}

TEST_CASE("a quotient by 0 is no loss, unless rounding made the 0", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  const Program of_squares = compiled(page, (x * x - y * y) / (x - y));
  ErrorTape squares(of_squares.code());
  CHECK(squares.at(std::vector{1.0, 1.0}).outside);
  CHECK_FALSE(squares.at(std::vector{1.0, 2.0}).outside);
  const Named z = page.scalar("z");
  const Program of_rest = compiled(page, y / ((x + y) - z));
  ErrorTape rest(of_rest.code());
  CHECK_FALSE(rest.at(std::vector{1.0, 1e-25, 1.0}).outside);
  CHECK(rest.at(std::vector{1.0, 1e-25, 1.0}).relative == 1);
  CHECK(rest.at(std::vector{1.0, 1.0, 2.0}).outside);
}
