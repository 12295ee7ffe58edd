// SPDX-License-Identifier: GPL-3.0-or-later
// Vector algebra and index notation: every true statement with false twins.
#include "algebra/decide/decide.h"

#include "algebra/verdict.h"
#include "catch.h"

using namespace rigor;
using namespace rigor::build;

TEST_CASE("the double cross product", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Named c = page.vector("C");
  const Term left = cross(a, cross(b, c));
  CHECK(is_proved(page.claim(left, b * dot(a, c) - c * dot(a, b))));
  CHECK(is_refuted(page.claim(left, b * dot(a, c) + c * dot(a, b))));
  CHECK(is_refuted(page.claim(left, b * dot(a, b) - c * dot(a, c))));
  CHECK(is_refuted(page.claim(cross(cross(a, b), c), b * dot(a, c) - c * dot(a, b))));
  CHECK(is_proved(page.claim(cross(cross(a, b), c), b * dot(a, c) - a * dot(b, c))));
}

TEST_CASE("the square of a cross product does not see the order of its factors", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Term gram = squared(a) * squared(b) - pow(dot(a, b), 2);
  CHECK(is_proved(page.claim(squared(cross(a, b)), gram)));
  CHECK(is_proved(page.claim(squared(cross(b, a)), gram)));
  CHECK(is_refuted(page.claim(squared(cross(a, b)), squared(a) * squared(b) + pow(dot(a, b), 2))));
  CHECK(is_refuted(page.claim(squared(cross(a, b)), squared(a) * length(b) - pow(dot(a, b), 2))));
  CHECK(is_refuted(page.claim(squared(cross(a, b)), squared(a) * squared(b) - dot(a, b))));
}

TEST_CASE("the product of two ε with one common index", "[algebra]") {
  Page page;
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  const IndexId k = page.index("k");
  const IndexId l = page.index("l");
  const IndexId m = page.index("m");
  const Term left = sum({i}, page.epsilon(i, j, k) * page.epsilon(i, l, m));
  const Term right = page.delta(j, l) * page.delta(k, m) - page.delta(j, m) * page.delta(k, l);
  const Decision decision = decide(page.claim(left, right, {j, k, l, m}));
  CHECK(decision.outcome == Outcome::proved);
  CHECK(decision.route == "component normal form");
  CHECK_FALSE(decision.vanishes);
  CHECK(is_refuted(page.claim(left, -right, {j, k, l, m})));
  const Term swapped = page.delta(j, l) * page.delta(k, m) - page.delta(j, m) * page.delta(j, l);
  CHECK(is_refuted(page.claim(left, swapped, {j, k, l, m})));
}

TEST_CASE("six free indices are decided, seven are not", "[algebra]") {
  Page page;
  std::vector<IndexId> x;
  for (const char* name : {"i", "j", "k", "l", "m", "n", "p"}) x.push_back(page.index(name));
  std::vector<Term> rows;
  for (const std::size_t row : {0u, 1u, 2u}) {
    for (const std::size_t column : {3u, 4u, 5u}) rows.push_back(page.delta(x[row], x[column]));
  }
  const std::vector<IndexId> six(x.begin(), x.begin() + 6);
  const Term left = page.epsilon(x[0], x[1], x[2]) * page.epsilon(x[3], x[4], x[5]);
  CHECK(is_proved(page.claim(left, page.determinant(rows), six)));
  std::swap(rows[0], rows[1]);
  CHECK(is_refuted(page.claim(left, page.determinant(rows), six)));
  const Term delta = page.delta(x[6], 1);
  CHECK(reason_open(page.claim(left * delta, delta * left, x)) ==
        "it has 7 free indices, more than the 6 that are evaluated");
}

TEST_CASE("a statement is refuted where its first component differs", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Term second_doubled = tuple(at(a, 1), 2 * at(a, 2), at(a, 3));
  const Decision decision = decide(page.claim(a, second_doubled));
  REQUIRE(decision.outcome == Outcome::refuted);
  CHECK(decision.route == "exact sample");
  CHECK(decision.sample->axes == std::vector<std::uint8_t>{2});
  CHECK(decision.sample->left == "1");
  CHECK(decision.sample->right == "2");
  CHECK(value_of(*decision.sample, a) == "0 1 0");
}

TEST_CASE("unit vectors are taken at every direction", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named n = page.unit("n");
  const Term parallel = n * dot(a, n);
  const Decision decision = decide(page.claim(a, parallel - cross(n, cross(n, a))));
  CHECK(decision.outcome == Outcome::proved);
  CHECK(decision.route == "component normal form, unit vectors at the generic point");
  CHECK(is_refuted(page.claim(a, parallel + cross(n, cross(n, a)))));
  CHECK(is_proved(page.claim(squared(n), page.number("1"))));
  CHECK(is_proved(page.claim(length(n), page.number("1"))));
  CHECK(is_refuted(page.claim(at(n, 3), page.number("1"))));
  CHECK(is_refuted(page.claim(squared(a), page.number("1"))));
}

TEST_CASE("a symmetric tensor is equal to its transpose, another one is not", "[algebra]") {
  Page page;
  const Named s = page.symmetric("S");
  const Named t = page.tensor("T");
  const Named w = page.vector("w");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  CHECK(is_proved(page.claim(at(s, i, j), at(s, j, i), {i, j})));
  CHECK(is_refuted(page.claim(at(t, i, j), at(t, j, i), {i, j})));
  CHECK(is_proved(page.claim(dot(s, w), dot(w, s))));
  CHECK(is_refuted(page.claim(dot(t, w), dot(w, t))));
  CHECK(is_proved(page.claim(sum({i, j}, page.epsilon(i, j, 1) * at(s, i, j)), page.zero())));
}

TEST_CASE("a proof of 0 = 0 is known as such", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  CHECK(decide(page.claim(dot(a, cross(a, b)), dot(b, cross(a, b)))).vanishes);
  CHECK(decide(page.claim(cross(a, a), page.zero_vector())).vanishes);
  CHECK_FALSE(decide(page.claim(cross(a, b), -cross(b, a))).vanishes);
  const IndexId i = page.index("i");
  CHECK(decide(page.claim(page.epsilon(i, i, 1), page.zero(), {i})).vanishes);
  CHECK_FALSE(decide(page.claim(page.delta(2, 2), page.number("1"))).vanishes);
}

TEST_CASE("symbols taken as zero are zero in samples and in proofs", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Named c = page.vector("C");
  CHECK(is_refuted(page.claim(cross(a, b + c), cross(a, b))));
  page.question.zeroed = {c.symbol};
  CHECK(is_proved(page.claim(cross(a, b + c), cross(a, b))));
  CHECK(is_refuted(page.claim(cross(a, b + c), cross(b, a))));
  page.define(c, 2 * a);
  CHECK(is_proved(page.claim(b + c, b)));
}

TEST_CASE("where only proofs count, what fails takes no search for a sample", "[algebra]") {
  const auto work_of = [](const Question& question, bool only_proofs) {
    Budget budget;
    Limits limits{.budget = &budget};
    limits.only_proofs = only_proofs;
    CHECK(decide(question, limits).outcome != Outcome::proved);
    return budget.used();
  };
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Named c = page.vector("C");
  const Question wrong = page.claim(cross(a, cross(b, c)), b * dot(a, c) + c * dot(a, b));
  CHECK(10 * work_of(wrong, true) < work_of(wrong, false));
  Limits limits;
  limits.only_proofs = true;
  const Question right = page.claim(cross(a, cross(b, c)), b * dot(a, c) - c * dot(a, b));
  CHECK(decide(right, limits).outcome == Outcome::proved);
}

TEST_CASE("where only proofs count, what fails at rough points is not tried", "[algebra]") {
  Limits limits;
  limits.only_proofs = true;
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Named c = page.vector("C");
  page.given(dot(a, b), page.zero());
  page.given(squared(a), squared(c));
  CHECK(reason_open(page.claim(squared(cross(a, b)), 2 * squared(a) * squared(b)), limits) ==
        "it fails where its assumptions hold");
  CHECK(decide(page.claim(squared(cross(a, b)), squared(c) * squared(b)), limits).outcome == Outcome::proved);
}

TEST_CASE("an assumption without which the claim fails at rough points is not taken away on trial",
          "[algebra]") {
  Page page;
  const Named a = page.scalar("a");
  const Named b = page.scalar("b");
  const Named c = page.scalar("c");
  const Named d = page.scalar("d");
  page.given(a, pow(b, 2) + b);
  page.given(b, pow(c, 2) + c);
  page.given(c, pow(d, 3) + d);
  const Term third = pow(d, 3) + d;
  const Term second = pow(third, 2) + third;
  const auto work = [&](bool fewest) {
    Budget budget;
    Limits limits{.budget = &budget};
    limits.fewest_assumptions = fewest;
    const Decision decision = decide(page.claim(a, pow(second, 2) + second), limits);
    CHECK(decision.outcome == Outcome::proved);
    CHECK(decision.assumptions.size() == 3);
    return budget.used();
  };
  CHECK(work(true) < work(false) + work(false) / 2);
}
