// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/measure/reference.h"

#include <cmath>

#include "catch.h"
#include "numeric/on_sample.h"
#include "numeric/rounded_reference.h"

using namespace rigor;
using namespace rigor::build;

TEST_CASE("a reference keeps what cancels in double", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  Samples samples(2, 0);
  samples.set_each(x.symbol, 0, {1e8, 1e150});
  samples.set_each(y.symbol, 0, {1e8 + 1.0, 3.0});
  const Reference result = reference(compiled(page, (pow(x, 2) - pow(y, 2)) + 2 * x), samples);
  CHECK(result.known[0] == Known::value);
  CHECK(result.values[0] == -1.0);
  CHECK(result.known[1] == Known::value);
}

TEST_CASE("a reference reaches beyond the range of double on the way", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  Samples samples(1, 0);
  samples.set(x.symbol, 0, 1e-200);
  const Reference result = reference(compiled(page, pow(x, 3) / pow(x, 3)), samples);
  CHECK(result.values[0] == 1.0);
}

TEST_CASE("what is 0 is known to be 0, and what has no value to have none", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  const Program same = compiled(page, pow(x + page.number("1"), 2) - (pow(x, 2) + 2 * x + page.number("1")));
  const Program third = compiled(page, x / 3 - x * (1 / page.number("3")));
  const Program none = compiled(page, root(-x));
  Samples samples(1, 0);
  samples.set(x.symbol, 0, 0.3);
  CHECK(reference(same, samples).known[0] == Known::zero);
  CHECK(reference(third, samples).known[0] == Known::zero);
  CHECK(reference(none, samples).known[0] == Known::undefined);
}

TEST_CASE("a small rest of large numbers is not called 0", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  Samples samples(1, 0);
  samples.set(x.symbol, 0, 1e300);
  samples.set(y.symbol, 0, 0x1p-1000);
  const Reference result = reference(compiled(page, (x + y) - x), samples);
  CHECK(result.known[0] == Known::value);
  CHECK(result.values[0] == 0x1p-1000);
}

TEST_CASE("a value that runs with 100 and 200 digits get wrong alike is right", "[numeric]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  Samples samples(1, 0);
  for (std::uint32_t i = 0; i < 3; ++i) {
    samples.set(a.symbol, i, 1e160 * (1.0 + i));
    samples.set(b.symbol, i, 1e-160 * (2.0 - i));
  }
  // A·B of 1 stands beside A² of 1e320, B² of 1e-320.
  const auto of = [&](const Term& term) { return reference(compiled(page, term), samples); };
  const Reference dot_form = of((squared(a + b) - squared(a) - squared(b)) / 2);
  CHECK(dot_form.known[0] == Known::value);
  CHECK(dot_form.values[0] == of(dot(a, b)).values[0]);
  const Reference square = of(squared(a + b) - squared(a) - 2 * dot(a, b));
  CHECK(square.known[0] == Known::value);
  CHECK(square.values[0] == of(squared(b)).values[0]);
  // Behind a root there are no rational numbers: more digits. (√(x² + y²) − x) x/y² is ½.
  const Term x = dot(a, a);
  const Term y = dot(b, b);
  const Reference half = of((root(x * x + y * y) - x) * x / (y * y));  // 1e-1280 beside 1
  CHECK(half.known[0] == Known::value);
  CHECK(half.values[0] == 0.5);
  const Term p = x * x;
  const Term q = y * y;
  CHECK(of((root(p * p + q * q) - p) * p / (q * q)).known[0] == Known::unknown);  // 1e-2560 beside 1
}

TEST_CASE("a 0 behind an irrational root is not claimed to be one", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  Samples samples(2, 0);
  samples.set_each(x.symbol, 0, {3.0, 4.0});
  const Reference result = reference(compiled(page, root(x) * root(x) - x), samples);
  CHECK(result.known[0] == Known::unknown);
  CHECK(result.known[1] == Known::zero);  // √4 is rational
}

TEST_CASE("only what is proved to have no value is undefined", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  Samples samples(1, 0);
  samples.set(x.symbol, 0, 1e300);
  samples.set(y.symbol, 0, 1e-300);
  const auto known = [&](const Term& term) { return reference(compiled(page, term), samples).known[0]; };
  const Term rest = (x + y) - x;
  CHECK(reference(compiled(page, 1 / rest), samples).values[0] == 1.0 / 1e-300);
  CHECK(known(1 / rest) == Known::value);
  CHECK(known(1 / (rest - y)) == Known::undefined);
  CHECK(known(root(rest)) == Known::value);
  CHECK(known(root(-rest)) == Known::undefined);
  CHECK(known(root(-x)) == Known::undefined);
  const Term unsettled = root(x) * root(x) - x;
  CHECK(known(1 / unsettled) == Known::unknown);
  CHECK(known(root(unsettled)) == Known::unknown);
  // exp(1e300) is beyond all numbers here, and has a value all the same; infinite/infinite is no number.
  CHECK(known(exp(x)) == Known::unknown);
  CHECK(known(exp(x) / exp(x)) == Known::unknown);
  CHECK(known(exp(-x) + y) == Known::value);
  samples.set(x.symbol, 0, std::numeric_limits<double>::infinity());
  CHECK(known(x / x) == Known::undefined);
}

TEST_CASE("rational numbers that grow too long are given up in time", "[numeric]") {
  Page page;
  const Named a = page.scalar("a");
  Term power = a;
  for (int i = 0; i < 6; ++i) power = pow(power, 8);
  const Term difference = a - a;
  Samples samples(1, 0);
  samples.set(a.symbol, 0, 0.3);
  const Named b = page.scalar("b");
  samples.set(b.symbol, 0, 0.7);
  const Reference result = reference(compiled(page, (power + b) - power - b), samples);
  CHECK(result.known[0] == Known::unknown);
  CHECK(reference(compiled(page, power * difference), samples).known[0] == Known::zero);
}
