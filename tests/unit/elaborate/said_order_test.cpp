// SPDX-License-Identifier: GPL-3.0-or-later

#include <string>

#include "catch.h"
#include "elaborate/evidence/evidence.h"

using namespace rigor;

namespace {

Evidence seen(std::string_view text) {
  Evidence evidence;
  see_said_order(text, evidence);
  return evidence;
}

std::string joined(const std::set<std::string>& letters) {
  std::string text;
  for (const std::string& letter : letters) text += letter + " ";
  return text;
}

std::string raised(std::string_view text) {
  Evidence evidence;
  see_said_raised(text, evidence);
  return joined(evidence.raised) + (evidence.speaks_of_raised ? "all" : "");
}

}  // namespace

TEST_CASE("words of a group or of what does not commute count for all letters", "[seen]") {
  CHECK(seen("Let $G$ be a group.").order_in_heading);
  CHECK(seen("in the symmetric group $S_3$").order_in_heading);
  CHECK(seen("Position and momentum do not commute.").order_in_heading);
  CHECK(seen("The elements of a noncommutative ring").order_in_heading);
  CHECK(seen("Words form a monoid.").order_in_heading);
  CHECK_FALSE(seen("The group velocity is small.").order_in_heading);
  CHECK_FALSE(seen("We group the terms. A group of waves comes.").order_in_heading);
  CHECK_FALSE(seen("Let $G$ be an abelian group.").order_in_heading);
  CHECK_FALSE(seen("Finite rotations do not commute.").order_in_heading);
  CHECK_FALSE(seen("The two operations commute.").order_in_heading);
}

TEST_CASE("letters around the noun are what the sentence calls them", "[seen]") {
  CHECK(joined(seen("where $a$ and $b$ are square matrices of $n$ rows").ordered) == "a b ");
  CHECK(joined(seen("Let $p, q$ be quaternions, and $t$ a time").ordered) == "p q ");
  CHECK(joined(seen("the matrices $\\alpha_i$ and $\\beta$, which $x$").ordered) == "\\alpha \\beta ");
  CHECK(joined(seen("the matrices $\\alpha_i$ and $\\beta$").labelled) == "\\alpha ");
  CHECK(joined(seen("$a$ is a number. The matrix of it is small").ordered).empty());
  CHECK(joined(seen("$a$ is a number that multiplies every entry of some matrix").ordered).empty());
  CHECK(joined(seen("where $a + b$ is a matrix").ordered).empty());
}

TEST_CASE("words of another arithmetic are kept", "[seen]") {
  CHECK(seen("The octonions").other_arithmetic == "octonion");
  CHECK(seen("In floating-point arithmetic").other_arithmetic == "floating point");
  CHECK(seen("so that modulo $p$").other_arithmetic == "modulo");
  CHECK(seen("equal mod 2").other_arithmetic == "mod");
  CHECK(seen("modulo $2\\pi$, in a modern model").other_arithmetic.empty());
  CHECK(seen("The operations of floating point").other_arithmetic.empty());
  CHECK(seen("The tropical year").other_arithmetic.empty());
}

TEST_CASE("upper indices show on the line", "[seen]") {
  CHECK(raised("with $x^0 = ct$ and $v^{1}$") == "v x ");
  CHECK(raised("the coordinates $x^i$") == "x ");
  CHECK(raised("the vector $u^\\mu$") == "u ");
  CHECK(raised("Upper indices come first") == "all");
  CHECK(raised("the polynomial in $x^i$ and $x^n$").empty());
  CHECK(raised("with $10^{-1}$, $x^{10}$, $e^1$ and $x^{1/2}$").empty());
}
