// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/engine/budget.h"

#include "algebra/engine/undecidable.h"
#include "algebra/verdict.h"
#include "catch.h"

using namespace rigor;
using namespace rigor::build;

TEST_CASE("a budget gives up behind its end, each time", "[algebra]") {
  Budget budget(10);
  budget.count(10);
  CHECK(budget.left() == 0);
  CHECK_FALSE(budget.exhausted());
  CHECK_THROWS_AS(budget.count(1), Undecidable);
  CHECK_THROWS_AS(budget.count(0), Undecidable);
  CHECK(budget.exhausted());
}

TEST_CASE("a question that takes more than its budget is undecided", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Question& question = page.claim(squared(cross(a, b)), squared(a) * squared(b) - pow(dot(a, b), 2));
  CHECK(is_proved(question));
  Budget none(5);
  CHECK(reason_open(question, {.budget = &none}).find("--effort") != std::string::npos);
  Budget enough(100'000);
  CHECK(decide(question, {.budget = &enough}).outcome == Outcome::proved);
  CHECK(enough.used() > 50);
  CHECK(enough.used() < 20'000);
}

TEST_CASE("numbers of samples that are squared again and again stay bounded", "[algebra]") {
  Page page;
  Named last = page.scalar("x");
  for (int k = 0; k < 40; ++k) {
    const Named next = page.scalar("x_" + std::to_string(k));
    page.define(next, Term(last) * Term(last));
    last = next;
  }
  Budget budget;
  const Decision decision = decide(page.claim(last, page.number("1")), {.budget = &budget});
  CHECK(decision.outcome != Outcome::proved);
  CHECK_FALSE(budget.exhausted());
}
