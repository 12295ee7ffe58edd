// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/sample/screen.h"

#include "algebra/engine/budget.h"
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
