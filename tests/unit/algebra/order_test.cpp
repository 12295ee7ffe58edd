// SPDX-License-Identifier: GPL-3.0-or-later
// Statements with <, ≤ and ≠, as assumptions and as claims.
#include "algebra/verdict.h"
#include "catch.h"

using namespace rigor;
using namespace rigor::build;

namespace {

constexpr Relation less = Relation::less;
constexpr Relation at_most = Relation::less_or_equal;
constexpr Relation unequal = Relation::unequal;

}  // namespace

TEST_CASE("squares and lengths are not negative", "[algebra]") {
  Page page;
  const Named x = page.scalar("x");
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Decision decision = decide(page.claim(page.zero(), at_most, pow(x, 2)));
  CHECK(decision.outcome == Outcome::proved);
  CHECK(decision.route == "sign of the difference");
  CHECK(is_refuted(page.claim(page.zero(), less, pow(x, 2))));
  CHECK(is_refuted(page.claim(page.zero(), at_most, pow(x, 3))));
  CHECK(is_proved(page.claim(page.zero(), at_most, squared(cross(a, b)))));
  CHECK(is_proved(page.claim(page.zero(), at_most, length(a) * absolute(x))));
  CHECK(is_proved(page.claim(-squared(a), less, page.number("1"))));
  CHECK(is_refuted(page.claim(page.zero(), at_most, dot(a, b))));
  CHECK(is_proved(page.claim(2 * x, at_most, pow(x, 2) + page.number("1"))));
  CHECK(is_refuted(page.claim(2 * x, less, pow(x, 2) + page.number("1"))));
  CHECK(is_refuted(page.claim(3 * x, at_most, pow(x, 2) + page.number("1"))));
}

TEST_CASE("a product tells the sign of a factor", "[algebra]") {
  Page page;
  const Named a = page.scalar("a");
  const Named b = page.scalar("b");
  const Named c = page.scalar("c");
  page.given(page.zero(), less, a * b);
  page.given(page.zero(), at_most, pow(c, 2) * b);
  page.given(b, less, page.zero());
  CHECK(is_proved(page.claim(a, less, page.zero())));
  CHECK(is_refuted(page.claim(page.zero(), less, a)));
  CHECK_FALSE(is_proved(page.claim(c, unequal, page.zero())));
}

TEST_CASE("the square of a dot product is at most the product of the squares", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  CHECK(is_proved(page.claim(pow(dot(a, b), 2), at_most, squared(a) * squared(b))));
  CHECK(is_refuted(page.claim(pow(dot(a, b), 2), less, squared(a) * squared(b))));
  CHECK(is_refuted(page.claim(squared(a) * squared(b), at_most, pow(dot(a, b), 2))));
}

TEST_CASE("moments of inertia are not negative where masses are positive", "[algebra]") {
  Page page;
  const Named m = page.scalars("m");
  const Named r = page.vectors("r");
  const Named n = page.unit("n");
  const ParticleId a = page.particle("\\alpha");
  const Term moment = over(a, m(a) * squared(cross(n, r(a))));
  CHECK(is_refuted(page.claim(page.zero(), at_most, moment)));
  page.given(page.zero(), less, m(a), {a});
  const Decision decision = decide(page.claim(page.zero(), at_most, moment));
  CHECK(decision.outcome == Outcome::proved);
  CHECK(decision.assumptions == std::vector<std::size_t>{0});
  CHECK(is_proved(page.claim(page.zero(), at_most, moment / 2)));
  CHECK(is_refuted(page.claim(page.zero(), less, moment)));
  CHECK(is_refuted(page.claim(moment, at_most, page.zero())));
  CHECK(is_proved(page.claim(page.zero(), less, over(a, m(a)))));
  CHECK(is_proved(page.claim(page.zero(), unequal, over(a, m(a)))));
  CHECK(is_proved(page.claim(page.zero(), at_most, moment + over(a, m(a) * squared(r(a))))));
  CHECK(is_refuted(page.claim(page.zero(), at_most, moment - over(a, m(a) * squared(r(a))))));
}

TEST_CASE("a strict order is tested at every direction", "[algebra]") {
  Page page;
  const Named n = page.unit("n");
  const Term one = page.number("1");
  CHECK(is_refuted(page.claim(page.zero(), less, one + at(n, 3))));
  CHECK(is_refuted(page.claim(at(n, 3), unequal, -one)));
  CHECK(is_proved(page.claim(page.zero(), less, 2 * dot(n, n) - one)));
  CHECK(is_proved(page.claim(page.zero(), at_most, one + at(n, 3))));
  CHECK(is_refuted(page.claim(page.zero(), at_most, one + 2 * at(n, 3))));
}

TEST_CASE("a chain of bounds", "[algebra]") {
  Page page;
  const Named i1 = page.scalar("I_1");
  const Named i2 = page.scalar("I_2");
  const Named i3 = page.scalar("I_3");
  const Named w = page.scalar("\\omega");
  page.given(i1, less, i2);
  page.given(page.zero(), less, i1);
  page.given(i2, less, i3);
  CHECK(satisfying_sample(page.question));
  const Term product = (i3 - i2) * (i2 - i1) / (i1 * i3);
  CHECK(is_proved(page.claim(page.zero(), less, product)));
  CHECK(is_refuted(page.claim(page.zero(), less, -product)));
  CHECK(is_proved(page.claim(product, unequal, page.zero())));
  CHECK(is_proved(page.claim(i1, unequal, i3)));
  CHECK(is_proved(page.claim(page.zero(), less, i3)));
  CHECK(is_proved(page.claim(page.zero(), at_most, product * pow(w, 2))));
  CHECK(is_refuted(page.claim(page.zero(), less, product * pow(w, 2))));
  CHECK(is_refuted(page.claim(i3, less, i1 + i2)));
  CHECK(is_proved(page.claim(1 / i3, less, 1 / i1)));
  CHECK(is_refuted(page.claim(1 / i1, less, 1 / i3)));
  SECTION("strictly, for a number that is not zero") {
    page.given(w, unequal, page.zero());
    CHECK(is_proved(page.claim(page.zero(), less, product * pow(w, 2))));
    CHECK(is_refuted(page.claim(page.zero(), less, product * w)));
  }
  SECTION("in a circle") {
    page.given(i3, less, i1);
    CHECK_FALSE(satisfying_sample(page.question));
    CHECK(decide(page.claim(i1, i1 + page.number("1"))).outcome == Outcome::undecided);
  }
}

TEST_CASE("assumptions that contradict each other in order", "[algebra]") {
  Page page;
  const Named a = page.scalar("I_1");
  const Named b = page.scalar("I_2");
  page.given(a, less, b);
  CHECK(satisfying_sample(page.question));
  SECTION("twice") { page.given(b, less, a); }
  SECTION("as equal") { page.given(a, b); }
  SECTION("as a negative square") { page.given(squared(b), less, page.zero()); }
  CHECK_FALSE(satisfying_sample(page.question));
}

TEST_CASE("a fact that bounds no single number", "[algebra]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  const Named z = page.scalar("z");
  page.given(page.zero(), less, x * y - z * z);
  CHECK(is_proved(page.claim(z * z, less, x * y + pow(x, 2))));
  CHECK(is_proved(page.claim(2 * z * z, less, 2 * x * y)));
  CHECK(is_refuted(page.claim(2 * z * z, less, x * y)));
  CHECK(is_refuted(page.claim(page.zero(), less, x)));
}

TEST_CASE("equations among the assumptions are solved first", "[algebra]") {
  Page page;
  const Named a = page.scalar("a");
  const Named b = page.scalar("b");
  const Named c = page.scalar("c");
  page.given(c, a + b);
  page.given(page.zero(), less, a);
  page.given(page.zero(), less, b);
  CHECK(is_proved(page.claim(a, less, c)));
  CHECK(is_proved(page.claim(4 * a * b, at_most, c * c)));
  CHECK(is_refuted(page.claim(4 * a * b, less, c * c)));
  CHECK(is_refuted(page.claim(c, less, a)));
}

TEST_CASE("what is positive is its own absolute value, and roots of products split", "[algebra]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  CHECK(is_refuted(page.claim(root(x * x), x)));
  page.given(page.zero(), less, x);
  CHECK(is_proved(page.claim(root(x * x), x)));
  CHECK(is_proved(page.claim(absolute(-x), x)));
  CHECK(is_refuted(page.claim(root(x * x), -x)));
  page.given(page.zero(), at_most, y);
  CHECK(is_proved(page.claim(root(x * y), root(x) * root(y))));
  CHECK(is_refuted(page.claim(root(x * y), 2 * root(x) * root(y))));
  page.given(x, less, y);
  CHECK(is_proved(page.claim(absolute(x - y), y - x)));
  CHECK(is_refuted(page.claim(absolute(x - y), x - y)));
}

TEST_CASE("what is positive may be divided by", "[algebra]") {
  Page page;
  const Named m = page.scalar("m");
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  page.given(m * x, m * y);
  CHECK(is_refuted(page.claim(x, y)));
  SECTION("positive") { page.given(page.zero(), less, m); }
  SECTION("not zero") { page.given(m, unequal, page.zero()); }
  CHECK(is_proved(page.claim(x, y)));
  CHECK(is_refuted(page.claim(x, 2 * y)));
}

TEST_CASE("a positive number for each particle", "[algebra]") {
  Page page;
  const Named m = page.scalars("m");
  const Named p = page.vectors("p");
  const ParticleId a = page.particle("\\alpha");
  page.given(page.zero(), less, m(a), {a});
  CHECK(is_proved(page.claim(page.zero(), at_most, squared(p(a)) / m(a), {a})));
  CHECK(is_proved(page.claim(page.zero(), at_most, over(a, squared(p(a)) / (2 * m(a))))));
  CHECK(is_refuted(page.claim(page.zero(), less, over(a, squared(p(a)) / m(a)))));
  CHECK(is_refuted(page.claim(m(a), less, page.number("2"), {a})));
  CHECK(is_proved(page.claim(absolute(m(a)), m(a), {}, {a})));
}

TEST_CASE("bounds with lengths and with sines", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Named x = page.scalar("\\theta");
  const Term one = page.number("1");
  CHECK(is_proved(page.claim(dot(a, b), at_most, length(a) * length(b))));
  CHECK(is_refuted(page.claim(length(a) * length(b), at_most, dot(a, b))));
  CHECK(is_proved(page.claim(length(a + b), at_most, length(a) + length(b))));
  CHECK(is_refuted(page.claim(length(a) + length(b), at_most, length(a + b))));
  CHECK(is_proved(page.claim(sin(x), at_most, one)));
  CHECK(is_proved(page.claim(cos(x), at_most, one)));
  CHECK(is_proved(page.claim(cos(x), less, 2 * one)));
  CHECK(is_refuted(page.claim(cos(x), less, one)));
  CHECK(is_refuted(page.claim(2 * cos(x), at_most, one)));
}

TEST_CASE("a sum over pairs of particles", "[algebra]") {
  Page page;
  const Named m = page.scalars("m");
  const Named r = page.vectors("r");
  const ParticleId a = page.particle("\\alpha");
  const ParticleId b = page.particle("\\beta");
  page.given(page.zero(), less, m(a), {a});
  CHECK(is_proved(page.claim(page.zero(), at_most, over(a, over(b, m(a) * m(b) * squared(r(a) - r(b)))))));
  CHECK(is_refuted(
      page.claim(page.zero(), at_most, over(a, over(b, m(a) * m(b) * dot(r(a), r(a) - 2 * r(b)))))));
}

TEST_CASE("a sum of squares that is not 0 is positive", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Named x = page.scalar("x");
  page.given(squared(a - b), unequal, page.zero());
  page.given(page.zero(), unequal, squared(b));
  CHECK(is_proved(page.claim(page.zero(), less, length(a - b))));
  CHECK(is_proved(page.claim(2 * dot(a, b), less, squared(a) + squared(b))));
  CHECK(is_proved(page.claim(page.zero(), less, squared(b) + pow(at(b, 1), 2) + pow(x, 2))));
  CHECK(is_refuted(page.claim(page.zero(), less, pow(at(b, 1), 2))));
  CHECK(is_refuted(page.claim(page.zero(), less, squared(a))));
}

TEST_CASE("what an order divides by is not 0", "[algebra]") {
  Page page;
  const Named x = page.scalar("x");
  CHECK(is_proved(page.claim(page.zero(), less, x * (1 / x))));
  CHECK(is_proved(page.claim(page.zero(), unequal, x * (x / x))));
  CHECK(is_refuted(page.claim(page.zero(), less, x * (x / x))));
}

TEST_CASE("a quadratic whose leading coefficient may be 0 is bounded by the rest", "[algebra]") {
  Page page;
  const Named a = page.scalar("a");
  const Named b = page.scalar("b");
  const Named x = page.scalar("x");
  page.given(page.zero(), at_most, a);
  page.given(page.zero(), at_most, a * b);
  const Term quadratic = a * pow(x, 2) + b;
  CHECK(is_refuted(page.claim(page.zero(), at_most, quadratic)));
  CHECK(is_proved(page.claim(page.zero(), at_most, quadratic + pow(b, 2) - b)));
  page.given(a, at_most, page.zero());
  CHECK(is_refuted(page.claim(page.zero(), at_most, quadratic)));
  page.given(page.zero(), at_most, b);
  CHECK(is_proved(page.claim(page.zero(), at_most, quadratic)));
}

TEST_CASE("a product has the sign of its factors", "[algebra]") {
  Page page;
  const Named x = page.scalar("x");
  page.given(page.zero(), less, x);
  page.given(2 * x, less, page.number("1"));
  CHECK(is_proved(page.claim(pow(x, 2), less, x)));
  CHECK(is_proved(page.claim(pow(x, 3), less, x)));
  CHECK(is_proved(page.claim(2 * pow(x, 2), less, x)));
  CHECK(is_refuted(page.claim(3 * pow(x, 2), less, x)));
  CHECK(is_refuted(page.claim(x, at_most, pow(x, 2))));
}

TEST_CASE("a product of factors of unknown sign has none", "[algebra]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  page.given(x, less, y);
  CHECK(is_refuted(page.claim(pow(x, 2), less, pow(y, 2))));
  CHECK(is_refuted(page.claim(pow(x, 2) * y, less, x * pow(y, 2))));
  CHECK(is_proved(page.claim(page.zero(), less, pow(y - x, 3))));
  page.given(page.zero(), less, x);
  CHECK(is_proved(page.claim(pow(x, 2) * y, less, x * pow(y, 2))));
}
