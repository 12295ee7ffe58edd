// SPDX-License-Identifier: GPL-3.0-or-later
// Proofs as values: what was reduced by what. Cofactors are multiplied out by an evaluator that knows nothing
// of the one that found them, and the polynomials they are about are compared with the sides of the question.
#include "expr/statement/proof.h"

#include <utility>

#include "algebra/replayed_proof.h"
#include "base/archive.h"
#include "catch.h"

using namespace rigor;
using namespace rigor::build;

namespace {

[[nodiscard]] std::string bytes_of(Proof proof) {
  ArchiveWriter writer;
  writer(proof);
  return writer.take();
}

/// `3/2 x0 x1^2 - 1`, to be compared with what was meant.
[[nodiscard]] std::string text_of(const ProofPolynomial& polynomial) {
  std::string text;
  for (const ProofTerm& term : polynomial) {
    text += (text.empty() ? "" : " + ") + term.coefficient;
    for (const ProofPower& power : term.powers) {
      text += " x" + std::to_string(power.letter);
      if (power.exponent != 1) text += "^" + std::to_string(power.exponent);
    }
  }
  return text;
}

using Kind = ProofStep::Kind;

}  // namespace

TEST_CASE("what follows from two assumptions is their combination", "[algebra]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  const Named z = page.scalar("z");
  const Named w = page.scalar("w");
  page.given(x * x, y * z);
  page.given(w, x);
  page.given(y * y, z * z);
  const Question& question = page.claim(w * w, y * z);
  const Proof proof = proof_of(question);
  CHECK(assumptions_of(proof) == std::vector<std::size_t>{0, 1});  // the third is not needed
  REQUIRE(proof.steps.size() == 1);
  REQUIRE(proof.steps[0].kind == Kind::combination);
  CHECK(proof.steps[0].cofactors.size() == 2);
  REQUIRE(proof.equations.size() == 2);
  CHECK(proof.equations[0].assumption == 0);
  CHECK(proof.equations[1].assumption == 1);
  CHECK(proof.equations[1].solved_for.has_value());
  CHECK(multiplies_out(proof));
  CHECK(is_about(proof, question));
  CHECK_FALSE(decide(page.claim(w * w, -(y * z))).proof);
  CHECK_FALSE(decide(page.claim(w * w, y * y)).proof);
}

TEST_CASE("what holds anyway has no steps", "[algebra]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  page.given(dot(a, b), page.zero());
  const Proof proof = proof_of(page.claim(cross(a, b), -cross(b, a)));
  CHECK(proof.steps.empty());
  CHECK(proof.letters.empty());
  CHECK(assumptions_of(proof).empty());
  CHECK(route_of(proof) == "component normal form");
}

TEST_CASE("each component has its own cofactors", "[algebra]") {
  Page page;
  const Named r = page.vector("r");
  const Named v = page.vector("v");
  page.given(dot(r, v), page.zero());
  const Question& question = page.claim(cross(r, cross(r, v)), -(squared(r) * v));
  const Proof proof = proof_of(question);
  CHECK(proof.steps.size() == 3);
  CHECK(proof.equations.size() == 1);
  CHECK(multiplies_out(proof));
  for (const ProofStep& step : proof.steps) {
    REQUIRE(step.cofactors.size() == 1);
    CHECK(step.cofactors[0].cofactor.size() == 1);  // r_i
  }
}

TEST_CASE("a factor that is not zero says why it is not", "[algebra]") {
  Page page;
  const Named a = page.scalar("a");
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  page.given(a * x, a * y);
  CHECK_FALSE(decide(page.claim(x, y)).proof);
  page.given(a, Relation::unequal, page.zero());
  const Proof proof = proof_of(page.claim(x, y));
  REQUIRE(proof.steps.size() == 1);
  REQUIRE(proof.steps[0].factors.size() == 1);
  CHECK(proof.steps[0].factors[0].exponent == 1);
  REQUIRE(proof.nonzero.size() == 1);
  CHECK(proof.nonzero[0].assumption == std::size_t{1});
  CHECK(assumptions_of(proof) == std::vector<std::size_t>{0, 1});
  CHECK(multiplies_out(proof));
}

TEST_CASE("a factor that assumptions reduce is taken as it was said", "[algebra]") {
  Page page;
  const Named a = page.scalar("a");
  const Named b = page.scalar("b");
  const Named c = page.scalar("c");
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  page.given(a, b * c);
  page.given(b * x, b * y);
  page.given(a, Relation::unequal, page.zero());
  const Proof proof = proof_of(page.claim(c * c * x, c * c * y));
  CHECK(multiplies_out(proof));
}

TEST_CASE("relations of roots, and squares of equations, are equations", "[algebra]") {
  Page page;
  const Named r = page.vector("r");
  const Named k = page.scalar("k");
  page.given(length(r), k);
  const Proof proof = proof_of(page.claim(squared(r), k * k));
  REQUIRE(proof.steps.size() == 1);
  CHECK(proof.steps[0].kind == Kind::combination);
  bool square = false;
  for (const ProofEquation& each : proof.equations)
    square = square || each.source == ProofEquation::Source::square;
  CHECK(square);
  CHECK(multiplies_out(proof));
  const Proof of_functions =
      proof_of(page.claim(squared(r) * squared(sin(k)), k * k - k * k * squared(cos(k))));
  CHECK(of_functions.functions);
  CHECK(multiplies_out(of_functions));
}

TEST_CASE("a vanishing determinant has the adjugate matrix for cofactors", "[algebra]") {
  Page page;
  const Named tensor = page.tensor("B");
  const Named moment = page.scalar("\\mu");
  const Named axis = page.unit("n");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  page.given(sum({j}, at(tensor, i, j) * at(axis, j)), moment * at(axis, i), {i});
  std::vector<Term> rows;
  for (const int k : {1, 2, 3}) {
    for (const int l : {1, 2, 3}) rows.push_back(k == l ? at(tensor, k, l) - moment : Term(at(tensor, k, l)));
  }
  const Proof proof = proof_of(page.claim(page.determinant(rows), page.zero()));
  REQUIRE(proof.steps.size() == 1);
  CHECK(proof.steps[0].kind == Kind::combination);
  CHECK(proof.equations.size() == 4);  // and n·n = 1
  CHECK(multiplies_out(proof));
}

TEST_CASE("moments are letters with a meaning", "[algebra]") {
  Page page;
  const Named m = page.scalars("m");
  const Named r = page.vectors("r");
  const Named v = page.vector("v");
  const ParticleId a = page.particle("\\alpha");
  page.given(over(a, m(a) * r(a)), page.zero_vector());
  const Proof proof = proof_of(page.claim(over(a, m(a) * dot(r(a), v)), page.zero()));
  REQUIRE(proof.steps.size() == 1);
  CHECK(multiplies_out(proof));
  std::size_t moments = 0;
  for (const ProofLetter& letter : proof.letters) {
    if (letter.kind != ProofLetter::Kind::moment) continue;
    ++moments;
    REQUIRE(letter.of.size() == 1);
    CHECK(letter.of[0].powers.size() == 2);  // m r_i
    CHECK(text_of(letter.over) == "1");
    for (const ProofPower& power : letter.of[0].powers) CHECK(proof.letters.at(power.letter).particle > 1);
  }
  CHECK(moments == 3);
}

TEST_CASE("an assumption about each particle is solved for a number of its own", "[algebra]") {
  Page page;
  const Named m = page.scalars("m");
  const Named r = page.vectors("r");
  const Named v = page.vectors("v");
  const Named omega = page.vector("\\omega");
  const ParticleId a = page.particle("\\alpha");
  page.given(v(a), cross(omega, r(a)), {}, {a});
  const Proof proof = proof_of(page.claim(over(a, m(a) * dot(v(a), r(a))), page.zero()));
  CHECK(proof.steps.empty());
  REQUIRE(proof.solutions.size() == 3);
  for (const ProofSolution& each : proof.solutions) {
    CHECK(proof.letters.at(each.letter).particle == 1);
    CHECK(each.worth.size() == 2);  // ω_j r_k − ω_k r_j
  }
  CHECK(assumptions_of(proof) == std::vector<std::size_t>{0});
}

TEST_CASE("a high power of what is given is divided out", "[algebra]") {
  Page page;
  const Named u = page.vector("u");
  const Named a = page.scalar("a");
  const Named b = page.scalar("b");
  const Named c = page.scalar("c");
  page.given(squared(u), page.number("1"));
  const Question& question = page.claim(pow(squared(u), 4) * squared(a + b + c), squared(a + b + c));
  const Proof proof = proof_of(question);
  REQUIRE(proof.steps.size() == 1);
  CHECK(proof.steps[0].kind == Kind::combination);
  CHECK(proof.steps[0].cofactors.at(0).cofactor.size() > 60);  // more than a search would try
  CHECK(multiplies_out(proof));
  CHECK(is_about(proof, question));
}

TEST_CASE("what is too long is not written down, and says so", "[algebra]") {
  Page page;
  const Named r = page.vector("r");
  const Named v = page.vector("v");
  const Named omega = page.vector("\\omega");
  page.given(v, cross(omega, r));
  std::vector<IndexId> indices;
  Term left = page.number("1");
  Term right = left;
  for (const char* name : {"i", "j", "k", "l", "m"}) {
    indices.push_back(page.index(name));
    left = left * at(v, indices.back());
    right = right * component(cross(omega, r), indices.back());
  }
  const Proof proof = proof_of(page.claim(left, right, indices));
  REQUIRE(proof.steps.size() == 243);
  CHECK(proof.steps.front().kind == Kind::combination);
  CHECK(proof.steps.back().kind == Kind::long_combination);
  CHECK(proof.steps.back().assumptions == std::vector<std::size_t>{0});
  CHECK(assumptions_of(proof) == std::vector<std::size_t>{0});
}

TEST_CASE("cases and signs are steps without cofactors", "[algebra]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  page.given(x * x * y, page.zero());
  const Proof by_cases = proof_of(page.claim(x * y, page.zero()));
  REQUIRE(by_cases.steps.size() == 1);
  CHECK(by_cases.steps[0].kind == Kind::cases);
  CHECK(by_cases.steps[0].cofactors.empty());
  CHECK(assumptions_of(by_cases) == std::vector<std::size_t>{0});
  page.question.assumptions.clear();
  page.given(x, Relation::less, y);
  const Proof by_signs = proof_of(page.claim(x, Relation::less_or_equal, y));
  CHECK(by_signs.method == Proof::Method::sign);
  REQUIRE(by_signs.steps.size() == 1);
  CHECK(by_signs.steps[0].kind == Kind::sign);
  CHECK(assumptions_of(by_signs) == std::vector<std::size_t>{0});
}

TEST_CASE("a proof names the definitions that were unfolded", "[algebra]") {
  Page page;
  const Named x = page.scalar("x");
  const Named y = page.scalar("y");
  page.define(y, x * x);
  CHECK(proof_of(page.claim(y, x * x)).unfolded == std::vector{y.symbol});
  CHECK(proof_of(page.claim(2 * y, y + y)).unfolded.empty());
  CHECK(proof_of(page.claim(page.number("4"), page.number("2") + page.number("2"))).method ==
        Proof::Method::value);
}

TEST_CASE("a proof that was tampered with does not hold", "[algebra]") {
  Page page;
  const Named r = page.vector("r");
  const Named v = page.vector("v");
  page.given(dot(r, v), page.zero());
  const Proof proof = proof_of(page.claim(squared(cross(r, v)), squared(r) * squared(v)));
  REQUIRE(proof.steps.size() == 1);
  Proof other = proof;
  other.steps[0].cofactors[0].cofactor[0].coefficient = "1";
  CHECK(cofactors_hold(other) ==
        (text_of(other.steps[0].cofactors[0].cofactor) == text_of(proof.steps[0].cofactors[0].cofactor)));
  other = proof;
  other.steps[0].cofactors[0].cofactor[0].coefficient = "1/7";
  CHECK_FALSE(cofactors_hold(other));
  other.steps[0].cofactors[0].cofactor[0].coefficient = "one";
  CHECK_FALSE(cofactors_hold(other));
  other = proof;
  other.steps[0].cofactors[0].equation = 7;
  CHECK_FALSE(cofactors_hold(other));
  other = proof;
  other.steps[0].numerator[0].powers.push_back({99, 1});
  CHECK_FALSE(cofactors_hold(other));
  other = proof;
  other.steps[0].numerator.clear();
  other.steps[0].cofactors.clear();
  CHECK(cofactors_hold(other));  // 0 = 0
  other.nonzero.push_back({});
  other.steps[0].factors.push_back({0, 1});
  CHECK_FALSE(cofactors_hold(other));  // 0 is not among what is not 0
}

TEST_CASE("a proof is the same in every run, and comes back from bytes", "[algebra]") {
  Page page;
  const Named s = page.symmetric("S");
  const Named u = page.vector("u");
  const Named v = page.vector("v");
  const Named a = page.scalar("a");
  const Named b = page.scalar("b");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  page.given(sum({j}, at(s, i, j) * at(u, j)), a * at(u, i), {i});
  page.given(sum({j}, at(s, i, j) * at(v, j)), b * at(v, i), {i});
  page.given(a, Relation::unequal, b);
  const Question& question = page.claim(dot(u, v), page.zero());
  const Proof proof = proof_of(question);
  CHECK(multiplies_out(proof));
  CHECK(bytes_of(proof) == bytes_of(proof_of(question)));
  const std::string bytes = bytes_of(proof);
  Proof again;
  ArchiveReader reader(bytes);
  reader(again);
  CHECK(reader.finished());
  CHECK(bytes_of(again) == bytes);
  std::size_t symbols = 0;
  for_each_symbol(again, [&](SymbolId& symbol) {
    ++symbols;
    symbol = SymbolId{static_cast<std::uint32_t>(symbol) + 1};
  });
  CHECK(symbols == again.letters.size());
  std::size_t seen = 0;
  for_each_symbol(std::as_const(again), [&](const SymbolId&) { ++seen; });
  CHECK(seen == symbols);
  CHECK(bytes_of(again) != bytes);
}
