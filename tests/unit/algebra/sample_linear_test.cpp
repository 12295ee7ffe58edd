// SPDX-License-Identifier: GPL-3.0-or-later
// Linear equations, and the samples that are found with them.
#include "algebra/sample/sample_linear.h"

#include "algebra/verdict.h"
#include "catch.h"

using namespace rigor;
using namespace rigor::build;

TEST_CASE("linear equations are solved by the first unknowns", "[algebra]") {
  const auto solution = solve_linear({{1, 1}, {1, -1}, {1, 0}}, {3, 1});
  REQUIRE(solution);
  CHECK((*solution)[0] == 2);
  CHECK((*solution)[1] == 1);
  CHECK((*solution)[2] == 0);
  CHECK(solve_linear({{1, 2}}, {1, 2}));
  CHECK_FALSE(solve_linear({{1, 2}}, {1, 3}));
  CHECK_FALSE(solve_linear({}, {1}));
}

TEST_CASE("assumptions that feed each other have a sample", "[algebra]") {
  Page page;
  const Named m = page.scalars("m");
  const Named a = page.vectors("a");
  const Named outside = page.vectors("F");
  const Named inside = page.vectors("f");
  const Named r = page.vectors("r");
  const ParticleId p = page.particle("\\alpha");
  page.given(m(p) * a(p), outside(p) + inside(p), {}, {p});
  page.given(over(p, cross(r(p), inside(p))), page.zero_vector());
  page.given(over(p, cross(r(p), outside(p))), page.zero_vector());
  CHECK(satisfying_sample(page.question));
}

TEST_CASE("a body has axes along the coordinates", "[algebra]") {
  Page page;
  const Named m = page.scalars("m");
  const Named r = page.vectors("r");
  const ParticleId a = page.particle("\\alpha");
  const Named moments = page.vector("J");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  page.given(page.zero(), Relation::less, m(a), {a});
  page.given(over(a, m(a) * r(a)), page.zero_vector());
  page.given(over(a, m(a) * (squared(r(a)) * page.delta(i, j) - component(r(a), i) * component(r(a), j))),
             at(moments, i) * page.delta(i, j), {i, j});
  CHECK(satisfying_sample(page.question));
}
