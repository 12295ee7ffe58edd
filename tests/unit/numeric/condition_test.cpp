// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/measure/condition.h"

#include <cmath>

#include "catch.h"
#include "numeric/measure/measure.h"
#include "numeric/on_sample.h"

using namespace rigor;
using namespace rigor::build;

TEST_CASE("the condition of a product is its number of factors, of a difference what cancels", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  Samples samples(2, 0);
  samples.set_each(x.symbol, 0, {3.0, 1.0});
  samples.set_each(y.symbol, 0, {2.0, 1.0 - 0x1p-20});
  const auto of = [&](const Term& term) { return condition_numbers(compiled(page, term), samples); };
  CHECK(of(x * y)[0] == Approx(2.0));
  CHECK(of(pow(x, 5) / y)[0] == Approx(6.0));
  CHECK(of(x - y)[0] == Approx(5.0));
  CHECK(of(x - y)[1] == Approx((2.0 - 0x1p-20) * 0x1p20));
  CHECK(of(root(x) * absolute(-y))[0] == Approx(1.5));
  CHECK(of(exp(x))[0] == Approx(3.0));
  CHECK(of(sin(x) + 0 * y)[0] == Approx(std::abs(3.0 * std::cos(3.0) / std::sin(3.0))));
  CHECK(of(cos(x))[0] == Approx(std::abs(3.0 * std::tan(3.0))));
  CHECK(std::isinf(of(x - x)[0]));
  CHECK(std::isnan(of(root(-x))[0]));
}

TEST_CASE("the condition of a vector is taken by its largest component", "[numeric]") {
  Page page;
  const Named a = page.vector("A");
  Samples samples(1, 0);
  samples.set(a.symbol, 0, 4.0);
  samples.set(a.symbol, 1, 1.0);
  samples.set(a.symbol, 2, -3.0);
  CHECK(condition_numbers(compiled(page, a + a), samples)[0] == Approx((4.0 + 1.0 + 3.0) / 4.0));
}

TEST_CASE("the condition of a sum over particles is as for the terms written out", "[numeric]") {
  Page page;
  const Named m = page.scalars("m");
  const Named x = page.scalars("x");
  const ParticleId alpha = page.particle("\\alpha");
  const ParticleId beta = page.particle("\\beta");
  Samples samples(1, 3);
  samples.set_particles(m.symbol, 0, {1.0, 2.0, 3.0});
  samples.set_particles(x.symbol, 0, {0.5, -1.0, 4.0});
  const Term sum = over(alpha, m(alpha) * x(alpha));
  const double total = 0.5 - 2.0 + 12.0;
  CHECK(condition_numbers(compiled(page, sum), samples)[0] == Approx(2.0 * 14.5 / total));
  // Σ_αβ m_α x_β = (Σ m)(Σ x): 6 · 3.5; a change of m_α weighs Σ x, one of x_β weighs Σ m.
  const Term twice = over(alpha, over(beta, m(alpha) * x(beta)));
  CHECK(condition_numbers(compiled(page, twice), samples)[0] == Approx((6.0 * 3.5 + 5.5 * 6.0) / 21.0));
  CHECK(condition_numbers(compiled(page, twice), samples, {}, 5).empty());
}

TEST_CASE("a condition number has digits enough, or is not given", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  Samples samples(1, 0);
  samples.set(x.symbol, 0, 1e160);
  samples.set(y.symbol, 0, 1e-160);
  const auto of = [&](const Term& term) { return condition_numbers(compiled(page, term), samples)[0]; };
  // ((x + y)² − x² − y²)/2 is x y: 2.
  CHECK(of((pow(x + y, 2) - pow(x, 2) - pow(y, 2)) / 2) == Approx(2.0));
  CHECK(of(root((pow(x + y, 2) - pow(x, 2) - pow(y, 2)) / 2)) == Approx(1.0));
  CHECK(std::isinf(of((x + y) - x - y)));  // 0 in rational numbers only
  CHECK(std::isnan(of(root(x) * root(x) - x)));
}

TEST_CASE("a condition number of 0 is found with 100 digits", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  Samples samples(1, 0);
  samples.set(x.symbol, 0, 2.5);
  CHECK(condition_numbers(compiled(page, exp(x) * exp(-x)), samples)[0] == 0.0);
  CHECK(condition_numbers(compiled(page, pow(sin(x), 2) + pow(cos(x), 2)), samples)[0] == 0.0);
}

TEST_CASE("functions of many digits are counted for what they cost", "[numeric]") {
  Page page;
  const Named x = page.scalar("x");
  Samples samples(1, 0);
  samples.set(x.symbol, 0, 1e200);  // e^-x is 0 to 100 and to 400 digits
  const Program program = compiled(page, (x + exp(-x)) - x);
  CHECK(work_of(program, samples, 1, 1'000) > 1'000);
  CHECK(std::isnan(condition_numbers(program, samples, {}, 400'000)[0]));
  CHECK(condition_numbers(program, samples, {}, 100).size() == 1);
}

TEST_CASE("three sums in each other do not overflow the count of the work", "[numeric]") {
  Page page;
  const Named m = page.scalars("m");
  const ParticleId alpha = page.particle("\\alpha");
  const ParticleId beta = page.particle("\\beta");
  const ParticleId gamma = page.particle("\\gamma");
  const Term term = over(alpha, over(beta, over(gamma, root(m(alpha) + m(beta) + m(gamma)))));
  constexpr std::size_t particles = std::size_t{1} << 22;
  Samples samples(1, particles);
  samples.set_particles(m.symbol, 0, std::vector<double>(particles, 1.0));
  CHECK(condition_numbers(compiled(page, term), samples).empty());
}
