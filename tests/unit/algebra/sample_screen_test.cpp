// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/sample/screen.h"

#include "algebra/engine/budget.h"
#include "algebra/words/operator_question.h"
#include "catch.h"
#include "expr/build.h"

using namespace rigor;
using namespace rigor::build;

namespace {

Equation equal(const Term& left, const Term& right) { return {.left = left.id, .right = right.id}; }

}  // namespace

TEST_CASE("a screen of a tree that has grown has the same samples, and counts the same work", "[algebra]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  page.given(x, 2 * y);
  const Question& question = page.claim(pow(x, 2), 3 * pow(y, 2));
  Budget budget;
  const SampleScreen drawn(question, {}, {.budget = &budget});
  const std::uint64_t work = budget.used();
  REQUIRE(work > 0);

  static_cast<void>(page.scalar("z"));
  const std::vector<Equation> claims{equal(pow(x, 2), 4 * pow(y, 2)), equal(pow(x, 2), 2 * pow(y, 2))};
  const std::unique_ptr<SampleScreen> grown = drawn.after_growth();
  CHECK(budget.used() == 2 * work);
  SampleScreen anew(question, {}, {.budget = &budget});
  CHECK(grown->screened(claims) == std::vector{Screened::holds, Screened::fails});
  CHECK(anew.screened(claims) == std::vector{Screened::holds, Screened::fails});
}

TEST_CASE("claims in words beside the same laws get the answers that each gets alone", "[algebra]") {
  Page page;
  const Named a = page.add({.name = "a", .noncommuting = true});
  const Named b = page.add({.name = "b", .noncommuting = true});
  page.given(a * b, b * a + page.number("1"));
  const Question& question = page.claim(a * (a * b) - (a * b) * a, 2 * a);
  const std::vector<Equation> claims{equal(a * b - b * a, page.number("1")), equal(a * b, b * a),
                                     equal((a * b) * b, (b * b) * a + 2 * b)};
  const Equation term = equal(a, page.zero());

  Budget together;
  ClaimsInWords all(question, together);
  std::uint64_t alone = 0;
  std::vector<bool> holding;
  for (const Equation& claim : claims) {
    Budget budget;
    holding.push_back(all.holds(claim));
    CHECK(ClaimsInWords(question, budget).holds(claim) == holding.back());
    alone += budget.used();
  }
  CHECK(holding == std::vector{true, false, true});
  CHECK(together.used() == alone);
  CHECK(all.multiple(term) == "-1");
}
