// SPDX-License-Identifier: GPL-3.0-or-later
// sin, cos and exp.
#include "algebra/verdict.h"
#include "catch.h"

using namespace rigor;
using namespace rigor::build;

TEST_CASE("the identities of sine and cosine", "[algebra]") {
  Page page;
  const Named x = page.scalar("\\theta");
  const Named y = page.scalar("\\phi");
  CHECK(is_proved(page.claim(pow(cos(x), 2) + pow(sin(x), 2), page.number("1"))));
  CHECK(is_refuted(page.claim(pow(cos(x), 2) - pow(sin(x), 2), page.number("1"))));
  CHECK(is_proved(page.claim(sin(2 * x), 2 * sin(x) * cos(x))));
  CHECK(is_refuted(page.claim(sin(2 * x), sin(x) * cos(x))));
  CHECK(is_proved(page.claim(cos(x + y), cos(x) * cos(y) - sin(x) * sin(y))));
  CHECK(is_refuted(page.claim(cos(x + y), cos(x) * cos(y) + sin(x) * sin(y))));
  CHECK(is_proved(page.claim(sin(x - y), sin(x) * cos(y) - cos(x) * sin(y))));
  CHECK(is_proved(page.claim(sin(-x), -sin(x))));
  CHECK(is_refuted(page.claim(cos(-x), -cos(x))));
  CHECK(is_proved(page.claim(pow(sin(x / 2), 2), (page.number("1") - cos(x)) / 2)));
  CHECK(is_refuted(page.claim(pow(sin(x / 2), 2), (page.number("1") + cos(x)) / 2)));
  CHECK(is_proved(page.claim(cos(3 * x), 4 * pow(cos(x), 3) - 3 * cos(x))));
  CHECK(is_proved(page.claim(sin(x / 3), 3 * sin(x / 9) - 4 * pow(sin(x / 9), 3))));
  CHECK(is_proved(page.claim(sin(x / 2) * cos(x / 2) + sin(x / 3) * cos(x / 3),
                             sin(x) / 2 + sin(2 * x / page.number("3")) / 2)));
  CHECK_FALSE(reason_open(page.claim(sin(13 * x), sin(13 * x) + x - x)).empty());
}

TEST_CASE("the exponential of a sum is a product", "[algebra]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  CHECK(is_proved(page.claim(exp(x + y), exp(x) * exp(y))));
  CHECK(is_refuted(page.claim(exp(x + y), exp(x) + exp(y))));
  CHECK(is_proved(page.claim(exp(-x) * exp(x), page.number("1"))));
  CHECK(is_proved(page.claim(root(exp(x)), exp(x / 2))));
  CHECK(is_refuted(page.claim(exp(2 * x), 2 * exp(x))));
  CHECK(is_proved(page.claim(exp(page.zero()), page.number("1"))));
  CHECK(is_proved(page.claim(page.zero(), Relation::less, exp(x))));
  CHECK(is_refuted(page.claim(exp(x), Relation::less, page.number("1"))));
}

TEST_CASE("angles that are products of other quantities", "[algebra]") {
  Page page;
  const Named w = page.scalar("\\omega");
  const Named t = page.scalar("t");
  const Named k = page.scalar("k");
  const Named m = page.scalar("m");
  CHECK(is_proved(page.claim(pow(cos(w * t), 2) + pow(sin(t * w), 2), page.number("1"))));
  CHECK(is_proved(page.claim(sin(k * t / m) * cos(t / m * k), sin(2 * k * t / m) / 2)));
  CHECK_FALSE(is_proved(page.claim(sin(w * t), sin(w) * sin(t))));
  const Term turn = tuple(cos(w * t), sin(w * t), page.zero());
  CHECK(is_proved(page.claim(length(turn), page.number("1"))));
}

TEST_CASE("angles in assumptions", "[algebra]") {
  Page page;
  const Named x = page.scalar("\\theta");
  const Named a = page.scalar("a");
  page.given(a, cos(x));
  CHECK(is_proved(page.claim(pow(sin(x), 2), page.number("1") - a * a)));
  CHECK(is_refuted(page.claim(pow(sin(x), 2), page.number("1") + a * a)));
}

TEST_CASE("an angle in a sample is exact", "[algebra]") {
  Page page;
  const Named x = page.scalar("\\theta");
  const Question& question = page.claim(sin(2 * x), sin(x) * cos(x));
  const Decision decision = decide(question);
  REQUIRE(decision.outcome == Outcome::refuted);
  CHECK(value_of(*decision.sample, x).find("arctan(") != std::string::npos);
  Sample sample = *decision.sample;
  sample.values[0].components = {"2*arctan(1/2)"};
  REQUIRE(replay(question, sample).has_value());
  CHECK(replay(question, sample)->left == "24/25");
  CHECK(replay(question, sample)->right == "12/25");
  for (const char* wrong : {"3*arctan(1/2)", "arctan(1/2)", "-2*arctan(1/2)", "2*arctan(1/2"}) {
    sample.values[0].components = {wrong};
    CHECK_FALSE(replay(question, sample).has_value());
  }
  sample.values[0].components = {"0"};
  CHECK(replay(question, sample)->left == "0");
}

TEST_CASE("a logarithm in a sample is exact", "[algebra]") {
  Page page;
  const Named x = page.scalar("x");
  const Question& question = page.claim(exp(2 * x), 2 * exp(x));
  Sample sample = *decide(question).sample;
  sample.values[0].components = {"log(3)"};
  CHECK(replay(question, sample)->left == "9");
  sample.values[0].components = {"3*log(1/2)"};
  CHECK(replay(question, sample)->left == "1/64");
  sample.values[0].components = {"log(-3)"};
  CHECK_FALSE(replay(question, sample).has_value());
}

TEST_CASE("a number that more than functions see is no exact angle", "[algebra]") {
  Page page;
  const Named x = page.scalar("\\theta");
  const Named w = page.scalar("\\omega");
  const Named t = page.scalar("t");
  CHECK_FALSE(is_proved(page.claim(sin(x), x)));
  CHECK(is_refuted(page.claim(x * cos(x), x + page.number("1"))));  // at 0
  CHECK(is_refuted(page.claim(sin(w * t), 2 * sin(w * t))));
  CHECK(is_refuted(page.claim(w * cos(w * t), cos(w * t))));
}

TEST_CASE("angles of particles", "[algebra]") {
  Page page;
  const Named x = page.scalars("\\theta");
  const Named m = page.scalars("m");
  const ParticleId a = page.particle("\\alpha");
  const ParticleId b = page.particle("\\beta");
  CHECK(is_proved(
      page.claim(over(a, m(a) * pow(cos(x(a)), 2)) + over(b, m(b) * pow(sin(x(b)), 2)), over(a, m(a)))));
  CHECK(is_refuted(page.claim(over(a, m(a) * pow(cos(x(a)), 2)), over(a, m(a)))));
  CHECK(is_proved(page.claim(cos(x(a) - x(b)), cos(x(a)) * cos(x(b)) + sin(x(a)) * sin(x(b)), {}, {a, b})));
  CHECK(is_refuted(page.claim(cos(x(a)), cos(x(b)), {}, {a, b})));
}
