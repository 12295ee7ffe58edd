// SPDX-License-Identifier: GPL-3.0-or-later
#include "catch.h"
#include "expr/build.h"

using namespace rigor;
using namespace rigor::build;

TEST_CASE("a tree is written as an S-expression", "[expr]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Named tensor = page.tensor("I");
  const Named m = page.scalars("m");
  const Named r = page.vectors("r");
  const IndexId i = page.index("i");
  const ParticleId alpha = page.particle("\\alpha");
  const auto text = [&](const Term& term) { return dump(page.tree, term.id); };

  CHECK(text(dot(a, cross(b, a))) == "(dot A (cross B A))");
  CHECK(text(over(alpha, m(alpha) * at(r(alpha), i))) ==
        "(particle-sum \\alpha (multiply m{\\alpha} r{\\alpha}[i]))");
  CHECK(text(sum({i}, at(tensor, 1, i))) == "(index-sum i I[1,i])");
  CHECK(text(pow(at(a, 2), -3) / 2) == "(divide (power A[2] -3) 2)");
  CHECK(text(page.epsilon(i, 2, 3) * page.delta(i, i)) == "(multiply epsilon[i,2,3] delta[i,i])");
  CHECK(text(page.basis(3)) == "e[3]");
  CHECK(text(component(cross(a, b), i)) == "(component[i] (cross A B))");
  const std::vector<ExprId> values{page.number("0").id, page.number("1").id};
  const Term table{&page.tree, page.tree.add_table({}, values, std::vector{Place(i).slot}, {{0, 1, 1}})};
  CHECK(text(table) == "(table[i]:0,1,1 0 1)");
}

TEST_CASE("the symbols of a tree come once each, in the order of their first occurrence", "[expr]") {
  Page page;
  const Named unused = page.vector("U");
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Term both = dot(b, a) + dot(b, b);
  CHECK(symbols_in(page.tree, both.id) == std::vector{b.symbol, a.symbol});
  CHECK(symbols_in(page.tree, static_cast<Term>(unused).id) == std::vector{unused.symbol});
}

TEST_CASE("a walk needs no call stack for depth", "[expr]") {
  Page page;
  Term deep = page.scalar("s");
  for (int i = 0; i < 100'000; ++i) deep = -deep;
  CHECK(symbols_in(page.tree, deep.id).size() == 1);
  CHECK(dump(page.tree, deep.id).size() == 100'000 * std::string("(negate )").size() + 1);
}
