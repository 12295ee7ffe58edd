// SPDX-License-Identifier: GPL-3.0-or-later
// Every operation, by statements that say what it is worth; each statement goes through samples and through
// the generic point.
#include "algebra/evaluator/evaluator.h"

#include "algebra/verdict.h"
#include "catch.h"

using namespace rigor;
using namespace rigor::build;

TEST_CASE("the sign of a permutation", "[algebra]") {
  CHECK(permutation_sign(1, 2, 3) == 1);
  CHECK(permutation_sign(3, 1, 2) == 1);
  CHECK(permutation_sign(2, 1, 3) == -1);
  CHECK(permutation_sign(2, 2, 3) == 0);
}

TEST_CASE("dot and cross products are what their components say", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  const IndexId k = page.index("k");
  CHECK(is_proved(page.claim(dot(a, b), sum({i}, at(a, i) * at(b, i)))));
  CHECK(is_proved(page.claim(dot(a, b), at(a, 1) * at(b, 1) + at(a, 2) * at(b, 2) + at(a, 3) * at(b, 3))));
  CHECK(is_refuted(page.claim(dot(a, b), at(a, 1) * at(b, 1) + at(a, 2) * at(b, 2) - at(a, 3) * at(b, 3))));
  const Term by_index = sum({j, k}, page.epsilon(i, j, k) * (at(a, j) * at(b, k)));
  CHECK(is_proved(page.claim(component(cross(a, b), i), by_index, {i})));
  CHECK(is_refuted(page.claim(component(cross(b, a), i), by_index, {i})));
  CHECK(is_proved(page.claim(cross(a, b), sum({i}, by_index * page.basis(i)))));
}

TEST_CASE("tensors: outer products, contractions and tuples", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Named t = page.tensor("T");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  const IndexId k = page.index("k");
  CHECK(is_proved(page.claim(dot(a * b, b), squared(b) * a)));
  CHECK(is_refuted(page.claim(dot(a * b, b), squared(b) * b)));
  CHECK(is_proved(page.claim(component(dot(t, a), i), sum({j}, at(t, i, j) * at(a, j)), {i})));
  CHECK(is_refuted(page.claim(component(dot(t, a), i), sum({j}, at(t, j, i) * at(a, j)), {i})));
  CHECK(is_proved(page.claim(component(dot(t, t), i, k), sum({j}, at(t, i, j) * at(t, j, k)), {i, k})));
  CHECK(is_proved(page.claim(a, tuple(at(a, 1), at(a, 2), at(a, 3)))));
  CHECK(is_refuted(page.claim(a, tuple(at(a, 1), at(a, 3), at(a, 2)))));
  CHECK(is_proved(page.claim(t + -t, (a * b) - (a * b))));
}

TEST_CASE("a determinant of rows is a triple product", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Named c = page.vector("C");
  const auto rows = [&](const Named& x, const Named& y) {
    return std::vector<Term>{at(x, 1), at(x, 2), at(x, 3), at(y, 1), at(y, 2), at(y, 3)};
  };
  std::vector<Term> scalar{at(a, 1), at(a, 2), at(a, 3)};
  std::vector<Term> vector{page.basis(1), page.basis(2), page.basis(3)};
  for (const Term& each : rows(b, c)) {
    scalar.push_back(each);
    vector.push_back(each);
  }
  CHECK(is_proved(page.claim(page.determinant(scalar), dot(a, cross(b, c)))));
  CHECK(is_refuted(page.claim(page.determinant(scalar), dot(a, cross(c, b)))));
  CHECK(is_proved(page.claim(page.determinant(vector), cross(b, c))));
  CHECK(is_refuted(page.claim(page.determinant(vector), cross(c, b))));
}

TEST_CASE("a table by index values is compared component by component", "[algebra]") {
  Page page;
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  const std::vector<ExprId> values{page.number("0").id, page.number("1").id};
  const std::vector<Slot> slots{Place(i).slot, Place(j).slot};
  const auto table = [&](std::vector<std::uint8_t> entry) {
    return Term{&page.tree, page.tree.add_table({}, values, slots, {std::move(entry)})};
  };
  CHECK(is_proved(page.claim(page.delta(i, j), table({1, 0, 0, 0, 1, 0, 0, 0, 1}), {i, j})));
  CHECK(is_refuted(page.claim(page.delta(i, j), table({1, 0, 0, 0, 1, 0, 0, 1, 1}), {i, j})));
}

TEST_CASE("a dummy index that is used again inside is another one", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const IndexId i = page.index("i");
  const Term trace = sum({i}, at(a, i));
  CHECK(is_proved(page.claim(sum({i}, sum({i}, page.delta(i, 1) * at(a, i))), 3 * at(a, 1))));
  CHECK(is_proved(page.claim(sum({i}, at(a, i) * trace), pow(trace, 2))));
  CHECK(is_refuted(page.claim(sum({i}, at(a, i) * trace), squared(a))));
}

TEST_CASE("powers, quotients and absolute values", "[algebra]") {
  Page page;
  const Named s = page.scalar("s");
  const Named a = page.vector("A");
  CHECK(is_proved(page.claim(pow(s, -2), 1 / (s * s))));
  CHECK(is_refuted(page.claim(pow(s, -2), 1 / s)));
  CHECK(is_proved(page.claim(pow(s, 0), page.number("1"))));
  CHECK(is_proved(page.claim(pow(absolute(s), 2), pow(s, 2))));
  CHECK(is_proved(page.claim(absolute(-s), absolute(s))));
  CHECK(is_refuted(page.claim(absolute(s), s)));
  CHECK(is_proved(page.claim(a / s, (1 / s) * a)));
  CHECK(is_proved(page.claim(page.number("0.5") * s, s / 2)));
}

TEST_CASE("a factor 0 does not give a value to a product that has none", "[algebra]") {
  Page page;
  const Named a = page.scalar("a");
  const Named b = page.scalar("b");
  const Named v = page.vector("v");
  const Named q = page.scalar("q");
  CHECK(is_proved(page.claim(a * (1 / a) + b * (b / (b * b)), page.number("2"))));
  CHECK(is_refuted(page.claim(a * (1 / a) + b * (b / (b * b)), page.number("3"))));
  CHECK_FALSE(is_refuted(page.claim(a * (1 / a), a * (1 / a))));
  CHECK(is_proved(page.claim((a * v) * pow(a, -1), v)));
  CHECK(is_refuted(page.claim((a * v) * pow(a, -1), 2 * v)));
  CHECK(reason_open(page.claim(page.zero() * (1 / (a - a)), page.zero())) ==
        "a denominator is zero for all values of the symbols");
  CHECK_FALSE(reason_open(page.claim(page.zero() * (v / (a - a)), page.zero_vector())).empty());
  page.define(q, 1 / (a - a));
  CHECK_FALSE(reason_open(page.claim(page.zero() * q, page.zero())).empty());
}

TEST_CASE("what is 0 at a sample still multiplies a quotient there", "[algebra]") {
  Page page;
  const Named a = page.scalar("a");
  Question question = page.claim(a * (1 / a), page.zero());
  question.claim.relation = Relation::unequal;
  CHECK_FALSE(is_refuted(question));
  const Sample zero{.particles = 0,
                    .values = {{a.symbol, 0, {"0"}}},
                    .axes = {},
                    .free_particles = {},
                    .left = {},
                    .right = {}};
  CHECK_FALSE(replay(question, zero).has_value());
  CHECK_FALSE(replay(page.claim(a * root(-page.number("1")), page.zero()), zero).has_value());
  CHECK(replay(page.claim(a * root(page.number("2")), page.zero()), zero).has_value());
}

TEST_CASE("ε and δ leave out terms that have no value", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  const Term quotient = 1 / (at(a, i) - at(a, j));
  CHECK(is_proved(page.claim(sum({i, j}, page.epsilon(i, j, 3) * quotient), 2 / (at(a, 1) - at(a, 2)))));
  CHECK(is_refuted(page.claim(sum({i, j}, page.epsilon(i, j, 3) * quotient), 2 / (at(a, 2) - at(a, 1)))));
}

TEST_CASE("a square of a root has a value where the root has one", "[algebra]") {
  Page page;
  const Named b = page.scalar("b");
  const Named v = page.scalar("v");
  const Sample negative{.particles = 0,
                        .values = {{b.symbol, 0, {"-1"}}},
                        .axes = {},
                        .free_particles = {},
                        .left = {},
                        .right = {}};
  CHECK(is_proved(page.claim(pow(root(b), 2), b)));
  CHECK(is_refuted(page.claim(pow(root(b), 2), -b)));
  CHECK_FALSE(is_refuted(page.claim(pow(root(b), 2), absolute(b))));
  CHECK_FALSE(replay(page.claim(pow(root(b), 2), absolute(b)), negative).has_value());
  page.define(v, root(b));
  CHECK(is_proved(page.claim(pow(v, 4), pow(b, 2))));
  CHECK(is_refuted(page.claim(pow(v, 4), 2 * pow(b, 2))));
  CHECK_FALSE(is_refuted(page.claim(pow(v, 2), absolute(b))));
  page.question.definitions.back().by_square = true;
  CHECK(is_proved(page.claim(pow(v, 2), b)));
  CHECK(is_refuted(page.claim(pow(v, 2), absolute(b))));
  CHECK(replay(page.claim(pow(v, 2), b), negative).has_value());
}
