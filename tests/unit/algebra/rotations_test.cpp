// SPDX-License-Identifier: GPL-3.0-or-later
// Rotations, and derivatives with axes that can be exchanged.
#include "algebra/sample/sample_rotation.h"
#include "algebra/verdict.h"
#include "catch.h"

using namespace rigor;
using namespace rigor::build;

TEST_CASE("a rotation is orthogonal and keeps the handedness", "[algebra]") {
  Page page;
  const Named r = page.rotation("R");
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  const IndexId k = page.index("k");
  const Decision decision = decide(page.claim(sum({k}, at(r, k, i) * at(r, k, j)), page.delta(i, j), {i, j}));
  CHECK(decision.outcome == Outcome::proved);
  CHECK(decision.route == "component normal form, rotations at the generic point");
  CHECK(is_refuted(page.claim(sum({k}, at(r, k, i) * at(r, j, k)), page.delta(i, j), {i, j})));
  CHECK(is_proved(page.claim(cross(dot(r, a), dot(r, b)), dot(r, cross(a, b)))));
  CHECK(is_refuted(page.claim(cross(dot(r, a), dot(r, b)), -dot(r, cross(a, b)))));
  CHECK(is_refuted(page.claim(cross(dot(r, a), dot(r, b)), dot(cross(a, b), r))));
  CHECK(is_proved(page.claim(dot(dot(r, a), dot(r, b)), dot(a, b))));
  CHECK(is_proved(page.claim(length(dot(r, a)), length(a))));
  CHECK(is_refuted(page.claim(dot(r, a), a)));
}

TEST_CASE("the determinant of a rotation is 1", "[algebra]") {
  Page page;
  const Named r = page.rotation("R");
  std::vector<Term> rows;
  for (const int i : {1, 2, 3}) {
    for (const int j : {1, 2, 3}) rows.push_back(at(r, i, j));
  }
  CHECK(is_proved(page.claim(page.determinant(rows), page.number("1"))));
  CHECK(is_refuted(page.claim(page.determinant(rows), -page.number("1"))));
}

TEST_CASE("two rotations do not commute, and their product is one", "[algebra]") {
  Page page;
  const Named r = page.rotation("R");
  const Named s = page.rotation("S");
  const Named a = page.vector("A");
  CHECK(is_proved(page.claim(squared(dot(r, dot(s, a))), squared(a))));
  CHECK(is_proved(page.claim(dot(dot(s, dot(r, a)), r), dot(dot(s, dot(r, a)), r))));
  const Decision decision = decide(page.claim(dot(r, dot(s, a)), dot(s, dot(r, a))));
  REQUIRE(decision.outcome == Outcome::refuted);
  for (const std::string& each : decision.sample->values[0].components) CHECK(each.size() <= 2);
}

TEST_CASE("the tensor of inertia of a rotated body is the rotated tensor", "[algebra]") {
  Page page;
  const Named q = page.rotation("R");
  const Named m = page.scalars("m");
  const Named r = page.vectors("r");
  const ParticleId a = page.particle("\\alpha");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  const IndexId k = page.index("k");
  const IndexId l = page.index("l");
  const auto tensor = [&](const Term& x, IndexId first, IndexId second) {
    return over(a,
                m(a) * (squared(x) * page.delta(first, second) - component(x, first) * component(x, second)));
  };
  const Term left = tensor(dot(q, r(a)), i, j);
  const Term rotated = sum({k, l}, at(q, i, k) * at(q, j, l) * tensor(r(a), k, l));
  CHECK(is_proved(page.claim(left, rotated, {i, j})));
  CHECK(is_refuted(page.claim(left, sum({k, l}, at(q, k, i) * at(q, l, j) * tensor(r(a), k, l)), {i, j})));
}

TEST_CASE("what is not a rotation is not replayed as one", "[algebra]") {
  Page page;
  const Named r = page.rotation("R");
  const Question& question = page.claim(at(r, 1, 1), at(r, 2, 2));
  Sample sample;
  sample.values = {{r.symbol, 0, {"3/5", "-4/5", "0", "4/5", "3/5", "0", "0", "0", "1"}}};
  CHECK(replay(question, sample).has_value());
  sample.values = {{r.symbol, 0, {"-1", "0", "0", "0", "1", "0", "0", "0", "1"}}};
  CHECK_FALSE(replay(question, sample).has_value());
  sample.values = {{r.symbol, 0, {"1", "1", "0", "0", "1", "0", "0", "0", "1"}}};
  CHECK_FALSE(replay(question, sample).has_value());
}

TEST_CASE("the known rotations are rotations, each once, the simplest first", "[algebra]") {
  std::uint32_t before = 0;
  for (const RotationMatrix& each : known_rotations()) {
    CHECK(is_rotation(each));
    CHECK(strangeness(each) >= before);
    before = strangeness(each);
  }
  CHECK(strangeness(known_rotations()[0]) == 0);
  CHECK(strangeness(known_rotations()[1]) == 1);
  CHECK(before == 2);
  CHECK(strangeness(rotation_of_quaternion({1, 2, 0, 0})) == 3);
  CHECK(is_rotation(rotation_of_quaternion({1, 2, -1, 2})));
}

TEST_CASE("space derivatives can be exchanged", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named first = page.derivative(a, By::space);
  const Named second = page.derivative(first, By::space);
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  const IndexId k = page.index("k");
  CHECK(is_proved(page.claim(at(second, i, j, k), at(second, i, k, j), {i, j, k})));
  CHECK(is_refuted(page.claim(at(second, i, j, k), at(second, j, i, k), {i, j, k})));
  CHECK(is_refuted(page.claim(at(first, i, j), at(first, j, i), {i, j})));
  const Term div_rot = sum({i, j, k}, page.epsilon(i, j, k) * at(second, k, i, j));
  CHECK(is_proved(page.claim(div_rot, page.zero())));
}

TEST_CASE("a derivative of a symmetric tensor is symmetric in the tensor's axes", "[algebra]") {
  Page page;
  const Named s = page.symmetric("S");
  const Named d = page.derivative(s, By::space);
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  const IndexId k = page.index("k");
  CHECK(is_proved(page.claim(at(d, i, j, k), at(d, j, i, k), {i, j, k})));
  CHECK(is_refuted(page.claim(at(d, i, j, k), at(d, i, k, j), {i, j, k})));
  page.given(at(d, 1, 2, 3), page.number("2"));
  CHECK(is_proved(page.claim(at(d, 2, 1, 3), page.number("2"))));
}
