// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/polynomial/given.h"

#include "derive/polynomial/canonical.h"
#include "derive/written.h"

using namespace rigor;
using namespace rigor::build;

TEST_CASE("the centre of mass takes a sum away, but not one that speaks of the particle elsewhere") {
  Page page;
  const Named m = page.scalars("m");
  const Named r = page.vectors("r");
  const Named v = page.vector("v");
  const ParticleId p = page.particle("\\alpha");
  Equation centre;
  centre.left = over(p, Term(m(p)) * Term(r(p))).id;
  centre.right = page.zero_vector().id;
  const auto rule = replacement_of(page.tree, centre, Orientation::as_written);
  REQUIRE(rule);
  IndexPolynomial vanishes = polynomial(over(p, Term(m(p)) * dot(v, r(p))));
  CHECK(replace_given(page.tree, *rule, vanishes));
  CHECK(vanishes.terms.empty());
  IndexPolynomial stays = polynomial(over(p, Term(m(p)) * dot(r(p), r(p))));
  CHECK_FALSE(replace_given(page.tree, *rule, stays));
}

TEST_CASE("an equation for one axis is not used for another") {
  Page page;
  const Named w = page.vector("w");
  const Named x = page.scalar("x");
  Equation given;
  given.left = at(w, 1).id;
  given.right = Term(x).id;
  const auto rule = replacement_of(page.tree, given, Orientation::as_written);
  REQUIRE(rule);
  IndexPolynomial both = polynomial(at(w, 1) * at(w, 2));
  REQUIRE(replace_given(page.tree, *rule, both));
  CHECK(canonical_text(page.tree.symbols, both) ==
        canonical_text(page.tree.symbols, polynomial(Term(x) * at(w, 2))));
}

TEST_CASE("a free letter of the equation stands for any letter and any axis") {
  Page page;
  const Named w = page.vector("w");
  const Named u = page.vector("u");
  const IndexId i = page.index("i");
  Equation given{.left = at(w, i).id, .right = (2 * at(u, i)).id, .indices = {i}};
  const auto rule = replacement_of(page.tree, given, Orientation::as_written);
  REQUIRE(rule);
  IndexPolynomial dotted = polynomial(dot(w, u) + at(w, 3));
  REQUIRE(replace_given(page.tree, *rule, dotted));
  CHECK(canonical_text(page.tree.symbols, dotted) ==
        canonical_text(page.tree.symbols, polynomial(2 * dot(u, u) + 2 * at(u, 3))));
}

TEST_CASE("the leading component is what is differentiated by the time") {
  Page page;
  const Named q = page.scalar("q");
  const Named k = page.scalar("k");
  const Named rate = page.derivative(q, By::time);
  Equation law;
  law.left = (Term(k) * Term(rate) + Term(q)).id;
  law.right = page.zero().id;
  const auto rule = replacement_of(page.tree, law, Orientation::leading);
  REQUIRE(rule);
  IndexPolynomial changed = polynomial(Term(rate));
  REQUIRE(replace_given(page.tree, *rule, changed));
  CHECK(canonical_text(page.tree.symbols, changed) ==
        canonical_text(page.tree.symbols, polynomial(-(Term(q) / Term(k)))));
}

TEST_CASE("an order and an equation of numbers replace nothing") {
  Page page;
  const Named x = page.scalar("x");
  const Equation order{.left = Term(x).id, .right = page.zero().id, .relation = Relation::less};
  CHECK_FALSE(replacement_of(page.tree, order, Orientation::as_written));
  const Equation numbers{.left = page.number("1").id, .right = page.zero().id};
  CHECK_FALSE(replacement_of(page.tree, numbers, Orientation::as_written));
}
