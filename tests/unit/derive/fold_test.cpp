// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/polynomial/fold.h"

#include "derive/written.h"

using namespace rigor;
using namespace rigor::build;

namespace {

std::string fold(const Term& term) {
  const auto result = folded(*term.tree, polynomial(term));
  return result ? dump(*term.tree, *result) : "?";
}

}  // namespace

TEST_CASE("contractions of vectors are dot products and squares of lengths") {
  Page page;
  const Named a = page.vector("a");
  const Named b = page.vector("b");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  CHECK(fold(sum({i}, at(a, i) * at(b, i))) == "(dot a b)");
  CHECK(fold(sum({i}, at(a, i) * at(a, i))) == "(power (length a) 2)");
  CHECK(fold(sum({i, j}, at(a, i) * at(b, i) * at(a, j) * at(b, j))) == "(power (dot a b) 2)");
}

TEST_CASE("an ε between two vectors is a cross product, between three a triple product") {
  Page page;
  const Named a = page.vector("a");
  const Named b = page.vector("b");
  const Named c = page.vector("c");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  const IndexId k = page.index("k");
  CHECK(fold(sum({j, k}, page.epsilon(i, j, k) * at(a, j) * at(b, k))) == "(component[i] (cross a b))");
  CHECK(fold(sum({i, j, k}, page.epsilon(i, j, k) * at(a, i) * at(b, j) * at(c, k))) ==
        "(dot a (cross b c))");
  CHECK(fold(sum({i, j, k}, page.epsilon(j, i, k) * at(a, i) * at(b, j) * at(c, k))) ==
        "(dot a (cross c b))");
}

TEST_CASE("a tensor takes its vector, from the side that it stands on") {
  Page page;
  const Named t = page.tensor("T");
  const Named s = page.symmetric("S");
  const Named a = page.vector("a");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  CHECK(fold(sum({j}, at(t, i, j) * at(a, j))) == "(component[i] (dot T a))");
  CHECK(fold(sum({j}, at(t, j, i) * at(a, j))) == "(component[i] (dot a T))");
  CHECK(fold(sum({j}, at(s, j, i) * at(a, j))) == "(component[i] (dot S a))");
  CHECK(fold(sum({i, j}, at(s, i, j) * at(a, i) * at(a, j))) == "(dot a (dot S a))");
}

TEST_CASE("what speaks of a particle stays under its sum") {
  Page page;
  const Named m = page.scalars("m");
  const Named r = page.vectors("r");
  const Named w = page.vector("w");
  const ParticleId p = page.particle("\\alpha");
  const IndexId i = page.index("i");
  CHECK(fold(sum({i}, at(w, i) * over(p, Term(m(p)) * at(r(p), i)))) ==
        "(particle-sum \\alpha (multiply m{\\alpha} (dot w r{\\alpha})))");
}

TEST_CASE("with an open letter the result is a vector") {
  Page page;
  const Named a = page.vector("a");
  const Named b = page.vector("b");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  const IndexPolynomial both = polynomial(sum({j}, at(a, j) * at(b, j) * at(a, i)));
  const auto vector = folded(page.tree, both, std::vector{i});
  REQUIRE(vector);
  CHECK(dump(page.tree, *vector) == "(multiply (dot a b) a)");
  CHECK_FALSE(folded(page.tree, polynomial(page.delta(i, j)), std::vector{i, j}));
}
