// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/meaning/both_orders.h"

#include "catch.h"
#include "check/checked.h"

using namespace rigor;

namespace {

std::string row(const std::string& statement, const std::string& before = "") {
  const std::string verdict = verdict_on(statement, before);
  return verdict.substr(0, verdict.find(' '));
}

}  // namespace

TEST_CASE("what holds only if two capitals commute is not proved", "[order]") {
  CHECK(row("(AB)^2 = A^2B^2") == "not-understood");
  CHECK(row("(A + B)(A - B) = A^2 - B^2") == "not-understood");
  CHECK(row("(AB)^2 = ABAB") == "proved");
  CHECK(row("A(B + C) = AB + AC") == "proved");
  CHECK(row("(A + b)^2 = A^2 + 2Ab + b^2") == "proved");
  CHECK(row("(a + b)^2 = a^2 + 2ab + b^2") == "proved");
}

TEST_CASE("capitals that something shows to be numbers commute", "[order]") {
  CHECK(row("(A + B)^2 = A^2 + 2AB + B^2", rigor_says("scalar A, B")) == "proved");
  CHECK(row("(A + B)^2 = A^2 + 2AB + B^2", "For real numbers $A$ and $B$\n") == "proved");
  CHECK(row("(A + B)^2 = A^2 + 2AB + B^2", "$$A = 2a$$\n$$B = a + b$$\n") == "proved");
  CHECK(row("(A + B)^2 = A^2 + AB + B^2", rigor_says("scalar A, B")) == "refuted");
  CHECK(row("\\frac{(A + B)^2}{AB} = \\frac AB + 2 + \\frac BA") == "proved");
}

TEST_CASE("in another arithmetic nothing is proved of open letters", "[order]") {
  CHECK(row("a(bc) = (ab)c", "The octonions are not associative.\n") == "not-understood");
  CHECK(row("a(bc) = (ab)c", rigor_says("scalar a, b, c") + "Unlike octonions,\n") == "proved");
}
