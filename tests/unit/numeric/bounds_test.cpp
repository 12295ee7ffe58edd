// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/measure/bounds.h"

#include <cmath>
#include <random>

#include "catch.h"
#include "numeric/on_sample.h"
#include "numeric/random_forms.h"
#include "numeric/rounded_reference.h"

using namespace rigor;
using namespace rigor::build;

TEST_CASE("the bound holds for random forms, and is not absurdly large", "[numeric]") {
  RandomForms forms;
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-2.0, 2.0);
  constexpr std::size_t count = 20;
  Samples samples(count, 0);
  for (const Named& vector : forms.page.vectors_of) {
    for (std::uint32_t i = 0; i < 3; ++i) {
      std::vector<double> values(count);
      for (double& value : values) value = uniform(random);
      samples.set_each(vector.symbol, i, values);
    }
  }
  int known = 0;
  int finite = 0;
  int sharp = 0;  // within 2^12 times the error, or a few units in the last place
  for (int form = 0; form < 150; ++form) {
    const Program program = compiled(forms.page, forms.scalar(3));
    const Reference exact = reference(program, samples);
    const BoundedResults results = evaluate_with_bounds(program, samples);
    const std::vector<double> plain = evaluate(program, samples);
    for (std::size_t i = 0; i < count; ++i) {
      if (exact.known[i] != Known::value && exact.known[i] != Known::zero) continue;
      ++known;
      // The reference is rounded to double: half a unit in the last place more.
      const double rounding = 0x1p-53 * std::abs(exact.values[i]) + 0x1p-1074;
      const double error = std::abs(results.values[i] - exact.values[i]);
      CHECK((std::isinf(results.bounds[i]) || error <= results.bounds[i] + rounding));
      CHECK((results.values[i] == plain[i] || std::isnan(plain[i])));
      if (std::isinf(results.bounds[i])) continue;
      ++finite;
      sharp += results.bounds[i] <= 4096.0 * (error + rounding) ? 1 : 0;
    }
  }
  CHECK(known > 2000);
  CHECK(finite >= known * 95 / 100);
  CHECK(sharp >= finite * 80 / 100);  // the others are right by luck
}

TEST_CASE("where bounds leave a sign open, rational numbers or more digits tell it", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  const Program difference = compiled(page, (x - y) * x);
  Samples samples(1, 0);
  const auto set = [&](const Named& letter, const LongNumber& digits) {
    samples.set(letter.symbol, 0, HighLow{1 / 3., 1 / 3. * 0x1p-54});
    samples.set_errors(letter.symbol, 0, {0x1p-100});
    samples.set_digits(letter.symbol, 0, digits);
  };
  set(x, {{1}, {3}});
  set(y, {{1}, {3}});
  const BoundedResults equal = enclosures(difference, samples, {1e-30});
  CHECK(equal.values == std::vector<double>{0});
  CHECK(equal.bounds == std::vector<double>{0});
  // One part in 1e250, which 100 digits do not hold.
  set(y, {{1, 1e-250}, {3}, 1e-270});
  const BoundedResults apart = enclosures(difference, samples, {1e-30});
  CHECK(apart.values[0] == Approx(-1e-250 / 9).epsilon(1e-12));
  CHECK(apart.bounds[0] < 1e-260);
  // And where nothing does, it stays open.
  set(y, {{1, 1e-250}, {3}, 1e-240});
  const BoundedResults open = enclosures(difference, samples, {1e-30});
  CHECK(open.bounds[0] > 1e-241);
}

TEST_CASE("the bound holds for all inputs within their uncertainty", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  const Program program = compiled(page, (x - y) * x / (x + y) + root(x));
  const double u = 1e-6;
  const auto at = [&](double a, double b, double uncertainty) {
    Samples samples(1, 0);
    samples.set(x.symbol, 0, a);
    samples.set(y.symbol, 0, b);
    return evaluate_with_bounds(program, samples, uncertainty);
  };
  const BoundedResults centre = at(3.0, 2.9, u);
  CHECK(centre.bounds[0] < 20.0 * u);
  double farthest = 0.0;
  for (const double a : {-u, 0.0, u}) {
    for (const double b : {-u, 0.0, u}) {
      const double there = at(3.0 * (1.0 + a), 2.9 * (1.0 + b), 0.0).values[0];
      farthest = std::max(farthest, std::abs(there - centre.values[0]));
    }
  }
  CHECK(farthest <= centre.bounds[0]);
  CHECK(farthest > 0.2 * centre.bounds[0]);
}

TEST_CASE("no bound is known behind a divisor that may be 0, or an overflow", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  Samples samples(1, 0);
  samples.set(x.symbol, 0, 1e200);
  const auto bound = [&](const Term& term) {
    return evaluate_with_bounds(compiled(page, term), samples).bounds[0];
  };
  CHECK(std::isinf(bound(x * x)));
  CHECK(std::isinf(bound(1 / (x - x))));
  CHECK(std::isinf(bound(1 / ((x + page.number("1")) - x))));
  CHECK(bound(1 / x) <= 0x1p-52 * 1e-200);
  CHECK(bound(1 / x) >= 0x1p-54 * 1e-200);
}

TEST_CASE("the bound of exp holds where its value vanishes in double", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  Samples samples(1, 0);
  for (const double at : {-800.0, -740.0}) {  // 0 and subnormal
    samples.set(x.symbol, 0, at);
    const BoundedResults result = evaluate_with_bounds(compiled(page, exp(x)), samples, 0.25);
    CHECK(result.bounds[0] >= std::exp(0.75 * at));
    CHECK(result.bounds[0] <= 1.001 * std::exp(0.75 * at));
  }
}

TEST_CASE("the root of what may be 0 is bounded by the root of the largest that it may be", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  Samples samples(1, 0);
  samples.set(x.symbol, 0, 2.0);
  const BoundedResults result = evaluate_with_bounds(compiled(page, root(x)), samples, 1.0);
  CHECK(result.bounds[0] >= 2.0);
  CHECK(result.bounds[0] <= 2.0 * (1.0 + 0x1p-48));
}
