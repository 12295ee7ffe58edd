// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/verdict.h"
#include "catch.h"

using namespace rigor;
using namespace rigor::build;

TEST_CASE("a product of lengths is the root of the product of squares", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Decision decision = decide(page.claim(length(a) * length(b), root(squared(a) * squared(b))));
  CHECK(decision.outcome == Outcome::proved);
  CHECK(decision.route == "component normal form, radicals");
  CHECK(is_refuted(page.claim(length(a) * length(b), squared(a) * squared(b))));
  CHECK(is_refuted(page.claim(length(a) * length(b), dot(a, b))));
}

TEST_CASE("lengths", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Named s = page.scalar("s");
  CHECK(is_proved(page.claim(length(-a), length(a))));
  CHECK(is_proved(page.claim(length(2 * a), 2 * length(a))));
  CHECK(is_proved(page.claim(length(s * a), absolute(s) * length(a))));
  CHECK(is_refuted(page.claim(length(s * a), s * length(a))));
  CHECK(is_refuted(page.claim(length(a + b), length(a) + length(b))));
  CHECK(is_proved(page.claim(length(cross(a, b)), root(squared(a) * squared(b) - pow(dot(a, b), 2)))));
  CHECK(is_proved(page.claim(squared(a / length(a)), page.number("1"))));
  CHECK(is_proved(page.claim((length(a) + length(b)) * (length(a) - length(b)), squared(a) - squared(b))));
  CHECK(is_proved(page.claim(pow(length(a), -3), length(a) / pow(squared(a), 2))));
  CHECK(
      is_proved(page.claim(dot(length(a) * b + length(b) * a, length(a) * b - length(b) * a), page.zero())));
}

TEST_CASE("an even power of a length makes no radical", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  CHECK(decide(page.claim(pow(length(a + b), 4), pow(squared(a) + squared(b) + 2 * dot(a, b), 2))).route ==
        "component normal form");
}

TEST_CASE("the root of a square is not the number itself", "[algebra]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  CHECK(is_proved(page.claim(root(pow(x, 2)), absolute(x))));
  CHECK(is_refuted(page.claim(root(pow(x, 2)), x)));
  CHECK(is_proved(page.claim(root(pow(x, 4)), pow(x, 2))));
  CHECK(is_proved(page.claim(absolute(x) * absolute(y), absolute(x * y))));
  CHECK(is_proved(page.claim(root(page.number("9") * pow(x, 2)), 3 * absolute(x))));
}

TEST_CASE("a perfect square under a root is found, also when it is written out", "[algebra]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  CHECK(is_proved(page.claim(root(x * x + 2 * x * y + y * y), absolute(x + y))));
  CHECK(is_refuted(page.claim(root(x * x + 2 * x * y + y * y), x + y)));
  CHECK(is_proved(page.claim(absolute(x * y + y * y), absolute(y) * absolute(x + y))));
}

TEST_CASE("a root of a product is split only where that holds for all signs", "[algebra]") {
  Page page;
  const Named f = page.scalar("f");
  const Named g = page.scalar("g");
  const Named h = page.scalar("h");
  // true for positive numbers; false where all three are negative
  CHECK(is_refuted(page.claim(root(f * g) * root(g * h), g * root(f * h))));
  CHECK(is_proved(page.claim(pow(root(f * g), 2), f * g)));
}

TEST_CASE("roots of numbers", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Term two = root(page.number("2"));
  CHECK(is_proved(page.claim(two * two * a, 2 * a)));
  CHECK(is_proved(page.claim(root(page.number("8")), 2 * two)));
  CHECK(is_proved(page.claim(1 / two, two / 2)));
  CHECK(is_proved(page.claim(root(page.number("0.25")), page.number("0.5"))));
  CHECK(is_refuted(page.claim(root(page.number("9")), page.number("4"))));
  CHECK(is_refuted(page.claim(two, page.number("1.41"))));
  CHECK(reason_open(page.claim(root(page.number("0") - page.number("4")), page.number("2"))) ==
        "a root of a negative number");
}
