// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/notation/first_order.h"

#include "derive/written.h"

using namespace rigor;
using namespace rigor::build;

TEST_CASE("terms with two small factors are left out, and what was left out is given back") {
  Page page;
  const Named d = page.scalar("d");
  const Named x = page.scalar("x");
  const Term whole = Term(x) + Term(d) * Term(x) + pow(d, 2) + Term(d) * Term(x) * Term(d);
  IndexPolynomial kept = polynomial(whole);
  const auto left_out = without_second_order(page.tree, std::vector{Term(d).id}, kept);
  REQUIRE(left_out);
  CHECK(kept.terms.size() == 2);
  CHECK(outcome(page, whole, written(page, kept) + Term{&page.tree, *left_out}) == Outcome::proved);
}

TEST_CASE("what is of second order goes out of a denominator") {
  Page page;
  const Named d = page.scalar("d");
  const Term whole = Term(d) / (page.number("1") + pow(d, 2));
  IndexPolynomial kept = polynomial(whole);
  const auto left_out = without_second_order(page.tree, std::vector{Term(d).id}, kept);
  REQUIRE(left_out);
  CHECK(outcome(page, written(page, kept), d) == Outcome::proved);
  CHECK(outcome(page, whole, written(page, kept) + Term{&page.tree, *left_out}) == Outcome::proved);
}

TEST_CASE("a component is small by itself, and so is its rate") {
  Page page;
  const Named w = page.vector("w");
  const Named rate = page.derivative(w, By::time);
  IndexPolynomial kept = polynomial(at(w, 1) * at(w, 2) + at(rate, 2) * at(w, 2));
  REQUIRE(without_second_order(page.tree, std::vector{at(w, 2).id}, kept));
  CHECK(kept.terms.size() == 1);
}

TEST_CASE("where the order cannot be seen nothing is left out") {
  Page page;
  const Named d = page.scalar("d");
  const std::vector<ExprId> small{Term(d).id};
  for (const Term& each : {page.number("1") / Term(d), root(d), sin(d), 1 / (page.number("1") + d)}) {
    IndexPolynomial kept = polynomial(each);
    CHECK_FALSE(without_second_order(page.tree, small, kept));
  }
}
