// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/verdict.h"
#include "catch.h"

using namespace rigor;
using namespace rigor::build;

TEST_CASE("a known sample stays where it meets a new assumption, and gets numbers for new symbols",
          "[algebra]") {
  Page page;
  const Named a = page.scalar("a");
  const Named b = page.scalar("b");
  const Named v = page.vector("v");
  page.given(a, 2 * b);
  const Sample known{.particles = 0,
                     .values = {{a.symbol, 0, {"14"}}, {b.symbol, 0, {"7"}}},
                     .axes = {},
                     .free_particles = {},
                     .left = {},
                     .right = {}};
  page.given(dot(v, v), page.number("1"));
  const auto extended = satisfying_sample(page.question, known);
  REQUIRE(extended.has_value());
  CHECK(value_of(*extended, a) == "14");
  CHECK(value_of(*extended, b) == "7");
  CHECK_FALSE(value_of(*extended, v).empty());
  CHECK(value_of(*satisfying_sample(page.question), a) != "14");
  page.given(b, page.number("3"));
  const auto changed = satisfying_sample(page.question, *extended);
  REQUIRE(changed.has_value());
  CHECK(value_of(*changed, a) == "6");
  CHECK(value_of(*changed, v) == value_of(*extended, v));
  page.given(a, b);
  CHECK_FALSE(satisfying_sample(page.question, *changed).has_value());
}

TEST_CASE("a known body keeps its particles", "[algebra]") {
  Page page;
  const Named m = page.scalars("m");
  const Named r = page.vectors("r");
  const Named c = page.scalar("c");
  const ParticleId p = page.particle("p");
  page.given(over(p, m(p) * r(p)), page.zero_vector());
  const auto body = satisfying_sample(page.question);
  REQUIRE(body.has_value());
  page.given(over(p, m(p)), c);
  const auto again = satisfying_sample(page.question, *body);
  REQUIRE(again.has_value());
  CHECK(again->particles == body->particles);
  CHECK(value_of(*again, r, 1) == value_of(*body, r, 1));
}

TEST_CASE("a curve of second degree with rational points has samples", "[algebra]") {
  Page page;
  const Named a = page.scalar("a");
  const Named b = page.scalar("b");
  const Named c = page.scalar("c");
  const auto not_zero = [&](const Named& each) {
    page.given(each, page.number("0"));
    page.question.assumptions.back().relation = Relation::unequal;
  };
  SECTION("with asymptotes that have rational slopes") { page.given(c * c, a * a + b * b); }
  SECTION("where one number alone is rational") { page.given(4 * a * a + 3 * b * b, page.number("9")); }
  not_zero(a);
  not_zero(b);
  CHECK(satisfying_sample(page.question).has_value());
}

TEST_CASE("a curve of second degree without rational points has none", "[algebra]") {
  Page page;
  const Named a = page.scalar("a");
  const Named b = page.scalar("b");
  page.given(a * a + b * b, page.number("3"));
  CHECK_FALSE(satisfying_sample(page.question).has_value());
}
