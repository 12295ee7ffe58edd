// SPDX-License-Identifier: GPL-3.0-or-later
// What follows is never said to fail; nearly all that does not follow is.
#include "algebra/rough/rough_screen.h"

#include <array>

#include "algebra/verdict.h"
#include "catch.h"

using namespace rigor;
using namespace rigor::build;

namespace {

bool fails(const Question& question) {
  Budget budget;
  const bool result = fails_at_rough_points(question, &budget);
  CHECK_FALSE(budget.exhausted());
  return result;
}

}  // namespace

TEST_CASE("what follows from equations does not fail at rough points", "[algebra]") {
  Page page;
  const Named a = page.scalar("a");
  const Named b = page.scalar("b");
  const Named c = page.scalar("c");
  page.given(a + b, c);
  CHECK_FALSE(fails(page.claim(pow(a + b, 2), pow(c, 2))));
  CHECK_FALSE(fails(page.claim(sin(a + b), sin(c))));
  CHECK(fails(page.claim(a, c)));
  CHECK(fails(page.claim(pow(a, 2) + pow(b, 2), pow(c, 2))));
}

TEST_CASE("a claim that holds at some of the points only does not count as failing", "[algebra]") {
  Page page;
  const Named a = page.scalar("a");
  const Named b = page.scalar("b");
  page.given(pow(a, 2), pow(b, 2));
  CHECK_FALSE(fails(page.claim(absolute(a), absolute(b))));
  CHECK_FALSE(fails(page.claim(pow(a, 4), pow(b, 4))));
}

TEST_CASE("a double root is met nearly, and its letter vanishes there", "[algebra]") {
  Page page;
  const Named a = page.scalar("a");
  const Named b = page.scalar("b");
  page.given(pow(a, 2) + pow(b, 2), page.zero());
  CHECK_FALSE(fails(page.claim(a, page.zero())));
  CHECK_FALSE(fails(page.claim(a, 3 * b)));
}

TEST_CASE("a letter that Newton's method takes to 0 tells nothing where it divides", "[algebra]") {
  Page page;
  const Named m = page.scalar("m");
  const Named j = page.vector("j");
  const Named k = page.vector("k");
  const Named b = page.vector("b");
  const Named c = page.vector("c");
  page.given(b - c, m * j);
  page.given(cross(b, c), m * k);
  CHECK_FALSE(fails(page.claim(dot(b - c, b + c) / m, dot(j, b + c))));
  CHECK_FALSE(fails(page.claim(cross(b, c) / m + (b - c) / m, j + k)));
  CHECK(fails(page.claim(cross(b, c) / m + (b - c) / m, j - k)));
}

TEST_CASE("without a point at which the assumptions hold nothing fails", "[algebra]") {
  Page page;
  const Named a = page.scalar("a");
  const Named b = page.scalar("b");
  page.given(pow(a, 2), -exp(b));
  CHECK_FALSE(fails(page.claim(a, b)));
}

TEST_CASE("vectors, unit vectors and sums over particles have rough points", "[algebra]") {
  Page page;
  const Named u = page.vector("u");
  const Named v = page.vector("v");
  const Named n = page.unit("n");
  const Named m = page.scalars("m");
  const Named r = page.vectors("r");
  const ParticleId alpha = page.particle("\\alpha");
  page.given(over(alpha, m(alpha) * r(alpha)), page.zero_vector());
  page.given(dot(u, n), page.zero());
  CHECK_FALSE(fails(page.claim(squared(cross(u, n)), squared(u))));
  CHECK(fails(page.claim(squared(cross(v, n)), squared(v))));
  CHECK_FALSE(fails(page.claim(dot(v, over(alpha, m(alpha) * r(alpha))), page.zero())));
  CHECK(fails(page.claim(over(alpha, m(alpha) * squared(r(alpha))), page.zero())));
}

TEST_CASE("an order fails where it is clearly the other way round", "[algebra]") {
  Page page;
  const Named a = page.scalar("a");
  const Named b = page.scalar("b");
  const Named c = page.scalar("c");
  page.given(a, Relation::less, b);
  page.given(b, Relation::less, c);
  page.given(page.zero(), Relation::less, a);
  CHECK_FALSE(fails(page.claim(a, Relation::less, c)));
  CHECK_FALSE(fails(page.claim(a * b, Relation::less_or_equal, pow(c, 2))));
  CHECK(fails(page.claim(c, Relation::less, a)));
  CHECK(fails(page.claim(pow(c, 2), Relation::less, a)));
  CHECK_FALSE(fails(page.claim(a, Relation::unequal, b)));
}

TEST_CASE("one program serves several choices of assumptions", "[algebra]") {
  Page page;
  const Named a = page.scalar("a");
  const Named b = page.scalar("b");
  const Named c = page.scalar("c");
  const Named d = page.scalar("d");
  page.given(a, pow(b, 2));
  page.given(b, pow(c, 2));
  page.given(c, pow(d, 2));
  const Question question = page.claim(a, pow(d, 8));
  const Scope scope(question, Scope::Definitions::unfolded);
  Budget budget;
  RoughScreen screen(scope, {0, 1, 2}, &budget);
  const std::array<std::size_t, 3> all{0, 1, 2};
  CHECK_FALSE(screen.fails_under(all));
  CHECK(screen.fails_under(std::array<std::size_t, 2>{0, 1}));
  CHECK(screen.fails_under(std::array<std::size_t, 2>{0, 2}));
  CHECK(screen.fails_under(std::array<std::size_t, 2>{1, 2}));
  CHECK_FALSE(screen.fails_under(all));
}
