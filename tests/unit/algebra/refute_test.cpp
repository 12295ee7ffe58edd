// SPDX-License-Identifier: GPL-3.0-or-later
// Samples: small, the same every time, and replayable.
#include "algebra/sample/refute.h"

#include "algebra/verdict.h"
#include "catch.h"

using namespace rigor;
using namespace rigor::build;

TEST_CASE("a sample is as small as it gets", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Named unused = page.vector("U");
  const Decision decision = decide(page.claim(dot(a, b), -dot(a, b)));
  REQUIRE(decision.outcome == Outcome::refuted);
  const Sample& sample = *decision.sample;
  CHECK(sample.particles == 0);
  CHECK(sample.values.size() == 2);
  CHECK(value_of(sample, a) == value_of(sample, b));  // one axis, twice
  CHECK(sample.left == "1");
  CHECK(sample.right == "-1");
  CHECK(value_of(sample, unused).empty());
}

TEST_CASE("one particle if one will do, two for a body about its centre of mass", "[algebra]") {
  Page page;
  const Named m = page.scalars("m");
  const Named r = page.vectors("r");
  const ParticleId a = page.particle("\\alpha");
  const Term squares = over(a, m(a) * squared(r(a)));
  CHECK(decide(page.claim(squares, page.zero())).sample->particles == 1);
  page.given(over(a, m(a) * r(a)), page.zero_vector());
  const Decision decision = decide(page.claim(squares, page.zero()));
  REQUIRE(decision.outcome == Outcome::refuted);
  CHECK(decision.sample->particles == 2);
  CHECK(value_of(*decision.sample, m, 1) == "1");
  CHECK(value_of(*decision.sample, m, 2) == "1");
  CHECK(decision.sample->left == "2");
}

TEST_CASE("masses and other scalars are positive where that will do", "[algebra]") {
  Page page;
  const Named s = page.scalar("s");
  const Named t = page.scalar("t");
  CHECK(value_of(*decide(page.claim(s * t, page.zero())).sample, s) == "1");
  CHECK(value_of(*decide(page.claim(absolute(s), s)).sample, s) == "-1");
}

TEST_CASE("a sample is the same in every run", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Named n = page.unit("n");
  const Question& question = page.claim(dot(cross(a, n), b), dot(a, b) * dot(a, n));
  CHECK(is_same(*decide(question).sample, *decide(question).sample));
  CHECK(is_refuted(question));
}

TEST_CASE("points are drawn in the same sequence, of all kinds", "[algebra]") {
  Page page;
  const Named s = page.symmetric("S");
  const Named n = page.unit("n");
  const Named r = page.vectors("r");
  const ParticleId alpha = page.particle("\\alpha");
  const IndexId i = page.index("i");
  const Term term = dot(dot(s, n), over(alpha, r(alpha)));
  page.claim(term, sum({i}, at(n, i)));
  const Scope scope(page.question, Scope::Definitions::unfolded);
  const Reach reached = reach(scope, page.question.claim);
  CHECK(reached.particles);
  CHECK(reached.symbols == std::vector{s.symbol, n.symbol, r.symbol});
  SampleSequence sequence(page.tree, reached, false);
  SampleSequence again(page.tree, reached, false);
  for (int point = 0; point < 32; ++point) {
    const SamplePoint first = sequence.next();
    const SamplePoint second = again.next();
    REQUIRE(first.particles() == second.particles());
    for (const Coordinate& at : first.coordinates()) CHECK(first[at] == second[at]);
    const auto tensor = first.values(s.symbol, 0);
    CHECK(tensor[1] == tensor[3]);
    CHECK(tensor[5] == tensor[7]);
    const auto unit = first.values(n.symbol, 0);
    CHECK(unit[0] * unit[0] + unit[1] * unit[1] + unit[2] * unit[2] == 1);
  }
}
