// SPDX-License-Identifier: GPL-3.0-or-later
// Rational statements, and the budgets that keep every decision short.
#include "algebra/verdict.h"
#include "catch.h"

using namespace rigor;
using namespace rigor::build;

namespace {

[[nodiscard]] bool mentions(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("rational identities are proved over a common denominator", "[algebra]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  CHECK(is_proved(page.claim(1 / (x + y) + 1 / (x - y), 2 * x / (x * x - y * y))));
  CHECK(is_refuted(page.claim(1 / (x + y) + 1 / (x - y), 2 * y / (x * x - y * y))));
  CHECK(is_proved(page.claim(1 / (x - y), -(1 / (y - x)))));
  CHECK(is_proved(page.claim(1 / (1 / x), x)));
  CHECK(is_proved(page.claim((2 * x + 2 * y) / (4 * x + 4 * y), page.number("0.5"))));
  CHECK(is_refuted(page.claim(1 / (x + y), 1 / x + 1 / y)));
  CHECK(is_proved(page.claim(pow(x / y, -3), pow(y, 3) / pow(x, 3))));
}

TEST_CASE("the projection along a vector", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Term along = b * (dot(a, b) / squared(b));
  CHECK(is_proved(page.claim(dot(a - along, b), page.zero())));
  CHECK(is_refuted(page.claim(dot(a - b * dot(a, b), b), page.zero())));
}

TEST_CASE("a denominator that is always zero is undecided", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  CHECK(reason_open(page.claim(1 / squared(cross(a, a)), page.number("1"))) ==
        "a denominator is zero for all values of the symbols");
  CHECK(reason_open(page.claim(1 / page.zero(), page.number("1"))) ==
        "a denominator is zero for all values of the symbols");
}

TEST_CASE("what would expand into too many terms is undecided, with the figure", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Term left = pow(dot(a, b), 6) * pow(squared(a), 5);
  const Term right = pow(dot(b, a) * squared(a), 5) * sum({page.index("i")}, at(a, 1) * at(b, 1));
  CHECK(is_refuted(page.claim(left, right)));
  const Term same = pow(dot(b, a) * squared(a), 5) * dot(a, b);
  CHECK(is_proved(page.claim(left, same)));
  const std::string reason = reason_open(page.claim(left, same + page.zero()), {.expanded_terms = 100});
  CHECK(mentions(reason, "terms, more than 100"));
}

TEST_CASE("exponents, numbers and ranks have their limits", "[algebra]") {
  Page page;
  const Named s = page.scalar("s");
  const Named t = page.tensor("T");
  CHECK(is_proved(page.claim(pow(s, 64), pow(s, 32) * pow(s, 32))));
  CHECK(reason_open(page.claim(pow(s, 65), s)) == "the exponent 65 is beyond ±64");
  CHECK(reason_open(page.claim(pow(s, -65), s)) == "the exponent -65 is beyond ±64");
  CHECK(reason_open(page.claim(page.number(std::string(1001, '1')), s)) ==
        "a number has 1001 digits, more than 1000");
  CHECK(reason_open(page.claim(t * t * s * t, t * t * s * t)) ==
        "a tensor of rank 6 is beyond the 4 that are evaluated");
  Term tower = 2 * s;
  for (int i = 0; i < 10; ++i) tower = pow(tower, 64);
  CHECK(mentions(reason_open(page.claim(tower, tower * tower)), "1000 digits"));
}

TEST_CASE("sums over many components end by their number of steps", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  Term product = page.number("1");
  std::vector<IndexId> dummies;
  for (int i = 0; i < 16; ++i) {
    dummies.push_back(page.index("i"));
    product = product * (at(a, dummies.back()) * at(a, dummies.back()));
  }
  for (const IndexId dummy : dummies) product = sum({dummy}, product);
  CHECK(mentions(reason_open(page.claim(product, pow(squared(a), 16))), "steps of evaluation"));
}
