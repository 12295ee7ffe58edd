// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/polynomial/contraction.h"

#include "derive/polynomial/canonical.h"
#include "derive/written.h"

using namespace rigor;
using namespace rigor::build;

TEST_CASE("two ε with one letter in common become two products of two δ") {
  Page page;
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  const IndexId k = page.index("k");
  const IndexId l = page.index("l");
  const IndexId m = page.index("m");
  const std::vector<IndexId> free{j, k, l, m};
  for (const Term& other : {page.epsilon(i, l, m), page.epsilon(l, i, m), page.epsilon(l, m, i)}) {
    const Term product = sum({i}, page.epsilon(i, j, k) * other);
    IndexPolynomial contracted = polynomial(product);
    REQUIRE(contract_epsilons(contracted));
    CHECK(contracted.terms.size() == 2);
    CHECK_FALSE(contract_epsilons(contracted));
    CHECK(outcome(page, product, written(page, contracted), free) == Outcome::proved);
    contracted.terms[1].coefficient = contracted.terms[1].coefficient * SmallRational(-1);
    CHECK(outcome(page, product, written(page, contracted), free) == Outcome::refuted);
  }
}

TEST_CASE("two ε without a common letter become six products of three δ") {
  Page page;
  std::vector<IndexId> free;
  for (const char* name : {"i", "j", "k", "l", "m", "n"}) free.push_back(page.index(name));
  const Term product = page.epsilon(free[0], free[1], free[2]) * page.epsilon(free[3], free[4], free[5]);
  IndexPolynomial contracted = polynomial(product);
  REQUIRE(contract_epsilons(contracted));
  REQUIRE(contracted.terms.size() == 6);
  for (std::size_t wrong = 0; wrong < 6; ++wrong) {
    IndexPolynomial twin = contracted;
    twin.terms[wrong].coefficient = twin.terms[wrong].coefficient * SmallRational(-1);
    CHECK(canonical_text(page.tree.symbols, twin) != canonical_text(page.tree.symbols, contracted));
  }
  CHECK(outcome(page, sum({free[0]}, product * page.delta(free[0], free[3])),
                sum({free[0]}, written(page, contracted) * page.delta(free[0], free[3])),
                {free[1], free[2], free[3], free[4], free[5]}) == Outcome::proved);
}

TEST_CASE("two and three common letters count the permutations") {
  Page page;
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  const IndexId k = page.index("k");
  const IndexId m = page.index("m");
  IndexPolynomial twice = polynomial(sum({i, j}, page.epsilon(i, j, k) * page.epsilon(i, j, m)));
  REQUIRE(contract_epsilons(twice));
  REQUIRE(contract_deltas(twice));
  CHECK(canonical_text(page.tree.symbols, twice) ==
        canonical_text(page.tree.symbols, polynomial(2 * page.delta(k, m))));
  IndexPolynomial thrice = polynomial(sum({i, j, k}, page.epsilon(i, j, k) * page.epsilon(i, j, k)));
  REQUIRE(contract_epsilons(thrice));
  REQUIRE(contract_deltas(thrice));
  CHECK(canonical_text(page.tree.symbols, thrice) ==
        canonical_text(page.tree.symbols, polynomial(page.number("6"))));
}

TEST_CASE("a δ renames a letter, has the trace 3 and is a number between numbered axes") {
  Page page;
  const Named a = page.vector("a");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  IndexPolynomial renamed = polynomial(sum({j}, page.delta(i, j) * at(a, j)));
  REQUIRE(contract_deltas(renamed));
  CHECK(canonical_text(page.tree.symbols, renamed) ==
        canonical_text(page.tree.symbols, polynomial(at(a, i))));
  IndexPolynomial trace = polynomial(sum({i}, page.delta(i, i)));
  REQUIRE(contract_deltas(trace));
  CHECK(trace.terms.at(0).coefficient == SmallRational(3));
  IndexPolynomial numbers = polynomial(page.delta(1, 1) + page.delta(1, 2) + page.epsilon(3, 2, 1));
  REQUIRE(contract_deltas(numbers));
  CHECK(canonical_text(page.tree.symbols, numbers) == canonical_text(page.tree.symbols, {}));
}

TEST_CASE("a rotation is orthogonal over either pair of slots, but not over a crossed one") {
  Page page;
  const Named r = page.rotation("R");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  const IndexId k = page.index("k");
  IndexPolynomial rows = polynomial(sum({j}, at(r, i, j) * at(r, k, j)));
  CHECK(contract_rotations(page.tree.symbols, rows));
  IndexPolynomial columns = polynomial(sum({j}, at(r, j, i) * at(r, j, k)));
  CHECK(contract_rotations(page.tree.symbols, columns));
  IndexPolynomial crossed = polynomial(sum({j}, at(r, i, j) * at(r, j, k)));
  CHECK_FALSE(contract_rotations(page.tree.symbols, crossed));
}

TEST_CASE("only a unit vector has the square 1") {
  Page page;
  const Named n = page.unit("n");
  const Named a = page.vector("a");
  IndexPolynomial unit = polynomial(dot(n, n));
  REQUIRE(contract_unit_vectors(page.tree.symbols, unit));
  CHECK(canonical_text(page.tree.symbols, unit) ==
        canonical_text(page.tree.symbols, polynomial(page.number("1"))));
  IndexPolynomial any = polynomial(dot(a, a));
  CHECK_FALSE(contract_unit_vectors(page.tree.symbols, any));
}

TEST_CASE("sums written out along the axes have the same value") {
  Page page;
  const Named a = page.vector("a");
  const Named b = page.vector("b");
  const Term product = dot(a, cross(b, a)) + dot(a, b);
  IndexPolynomial along = polynomial(product);
  REQUIRE(write_out_sums(along));
  for (const IndexMonomial& term : along.terms) CHECK(term.indices.empty());
  CHECK(outcome(page, product, written(page, along)) == Outcome::proved);
}

TEST_CASE("the square of a cosine is replaced, its first power is not") {
  Page page;
  const Term x = page.scalar("x");
  IndexPolynomial square = polynomial(pow(cos(x), 3));
  REQUIRE(replace_cosines(square));
  CHECK(square.terms.size() == 2);
  CHECK(outcome(page, pow(cos(x), 3), written(page, square)) == Outcome::proved);
  IndexPolynomial first = polynomial(cos(x));
  CHECK_FALSE(replace_cosines(first));
}
