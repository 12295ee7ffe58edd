// SPDX-License-Identifier: GPL-3.0-or-later
// Definitions, and which assumptions bear on a claim.
#include "algebra/point/scope.h"

#include "algebra/verdict.h"
#include "base/check.h"
#include "catch.h"

using namespace rigor;
using namespace rigor::build;

TEST_CASE("definitions are unfolded only where a proof needs them", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Named c = page.vector("C");
  const Named d = page.vector("D");
  page.define(c, a + b);
  page.define(d, 2 * c);
  SECTION("not at all") {
    const Decision decision = decide(page.claim(cross(c, d), -cross(d, c)));
    CHECK(decision.outcome == Outcome::proved);
    CHECK(decision.unfolded.empty());
  }
  SECTION("one inside the other") {
    const Decision decision = decide(page.claim(cross(d, a), 2 * cross(b, a)));
    CHECK(decision.outcome == Outcome::proved);
    CHECK(decision.unfolded == std::vector{d.symbol, c.symbol});
  }
  SECTION("a refutation is one of what the symbols stand for") {
    const Decision decision = decide(page.claim(cross(d, a), cross(b, a)));
    REQUIRE(decision.outcome == Outcome::refuted);
    CHECK(decision.unfolded == std::vector{d.symbol, c.symbol});
    CHECK(value_of(*decision.sample, c).empty());
    CHECK_FALSE(value_of(*decision.sample, b).empty());
  }
}

TEST_CASE("a definition by components binds its own indices", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named t = page.tensor("T");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  // T_ij = A_i + 2 A_j, with i as a dummy of the caller as well
  page.define(t, at(a, i) + 2 * at(a, j), {i, j});
  CHECK(is_proved(page.claim(at(t, j, i), at(a, j) + 2 * at(a, i), {i, j})));
  CHECK(is_refuted(page.claim(at(t, j, i), at(a, i) + 2 * at(a, j), {i, j})));
  CHECK(is_proved(page.claim(sum({i}, at(t, i, i)), 3 * sum({j}, at(a, j)))));
  CHECK(is_proved(
      page.claim(sum({i}, at(t, j, i) * at(a, i)), at(a, j) * sum({i}, at(a, i)) + 2 * squared(a), {j})));
  CHECK(is_proved(page.claim(component(t, 1, 2), at(a, 1) + 2 * at(a, 2))));
}

TEST_CASE("a definition for each particle", "[algebra]") {
  Page page;
  const Named m = page.scalars("m");
  const Named r = page.vectors("r");
  const Named outside = page.vectors("r'");
  const Named center = page.vector("R");
  const ParticleId a = page.particle("\\alpha");
  const ParticleId b = page.particle("\\beta");
  page.define(outside(a), center + r(a));
  CHECK(is_proved(page.claim(over(b, m(b) * outside(b)), over(b, m(b)) * center + over(a, m(a) * r(a)))));
  CHECK(is_refuted(page.claim(over(b, m(b) * outside(b)), center + over(a, m(a) * r(a)))));
  CHECK(is_proved(page.claim(outside(a) - outside(b), r(a) - r(b), {}, {a, b})));
  CHECK(is_refuted(page.claim(outside(a) - outside(b), r(b) - r(a), {}, {a, b})));
}

TEST_CASE("what is declared of a symbol is not taken for granted where it is defined", "[algebra]") {
  Page page;
  const Named n = page.unit("n");
  page.define(n, tuple(page.number("2"), page.zero(), page.zero()));
  CHECK(is_refuted(page.claim(squared(n), page.number("1"))));
}

TEST_CASE("circular definitions end", "[algebra]") {
  Page page;
  const Named s = page.scalar("s");
  const Named t = page.scalar("t");
  page.define(s, t + page.number("1"));
  page.define(t, s - page.number("1"));
  CHECK(reason_open(page.claim(s, t)) == "it nests too deeply, or its definitions are circular");
}

TEST_CASE("an expression as deep as the parser lets through is evaluated", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Named s = page.scalar("s");
  Term vector = a;
  Term scalar = s;
  for (int level = 0; level < 250; ++level) {
    vector = vector + b;
    scalar = s + (level % 2 == 0 ? -scalar : scalar);
  }
  CHECK(is_proved(page.claim(vector, a + 250 * b)));
  CHECK(is_refuted(page.claim(vector, a + 249 * b)));
  CHECK(decide(page.claim(scalar, s)).outcome != Outcome::undecided);
}

TEST_CASE("a definition that does not fit its symbol is our own bug", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  page.define(a, page.number("1"));
  CHECK_THROWS_AS(decide(page.claim(a, a)), InternalError);
}

TEST_CASE("assumptions about other things are left alone", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Named c = page.vector("C");
  const Named d = page.vector("D");
  page.given(dot(a, b), page.zero());
  page.given(dot(b, c), page.zero());
  page.given(squared(d), -page.number("1"));
  page.claim(a, a);
  const Scope scope(page.question, Scope::Definitions::unfolded);
  CHECK(relevant_assumptions(scope) == std::vector<std::size_t>{0, 1});
  CHECK(is_refuted(page.claim(a, 2 * a)));
  page.given(page.number("1"), page.number("2"));
  CHECK(decide(page.claim(a, 2 * a)).outcome == Outcome::undecided);
}
