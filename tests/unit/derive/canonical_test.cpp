// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/polynomial/canonical.h"
#include "derive/polynomial/collected.h"

#include "derive/written.h"

using namespace rigor;
using namespace rigor::build;

namespace {

std::string text(const Term& term) { return canonical_text(term.tree->symbols, polynomial(term)); }

}  // namespace

TEST_CASE("names of summed letters and the order of factors do not matter") {
  Page page;
  const Named a = page.vector("a");
  const Named b = page.vector("b");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  CHECK(text(sum({i, j}, at(a, i) * at(b, i) * at(a, j) * at(a, j))) ==
        text(sum({i, j}, at(a, i) * at(a, i) * at(b, j) * at(a, j))));
  CHECK(text(sum({i, j}, at(a, i) * at(b, i) * at(a, j) * at(b, j))) !=
        text(sum({i, j}, at(a, i) * at(a, i) * at(b, j) * at(b, j))));
}

TEST_CASE("free letters are told apart") {
  Page page;
  const Named a = page.vector("a");
  const Named b = page.vector("b");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  CHECK(text(at(a, i) * at(b, j)) != text(at(a, j) * at(b, i)));
}

TEST_CASE("a symmetric tensor's slots can be exchanged, another's cannot") {
  Page page;
  const Named s = page.symmetric("S");
  const Named t = page.tensor("T");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  CHECK(text(at(s, i, j)) == text(at(s, j, i)));
  CHECK(text(at(t, i, j)) != text(at(t, j, i)));
}

TEST_CASE("ε is cyclic and odd") {
  Page page;
  const Named a = page.vector("a");
  const Named b = page.vector("b");
  const Named c = page.vector("c");
  CHECK(text(dot(a, cross(b, c))) == text(dot(b, cross(c, a))));
  CHECK(text(dot(a, cross(b, c))) == text(-dot(b, cross(a, c))));
  CHECK(text(dot(a, cross(b, c))) != text(dot(b, cross(a, c))));
}

TEST_CASE("what is antisymmetric in what is symmetric vanishes") {
  Page page;
  const Named a = page.vector("a");
  const Named b = page.vector("b");
  IndexPolynomial zero = polynomial(dot(b, cross(a, a)));
  CHECK(drop_antisymmetric(page.tree.symbols, zero));
  CHECK(zero.terms.empty());
  IndexPolynomial other = polynomial(dot(b, cross(a, cross(a, b))));
  CHECK_FALSE(drop_antisymmetric(page.tree.symbols, other));
}

TEST_CASE("a sum over one particle's letters is the same by any name, a product of two sums is two") {
  Page page;
  const Named m = page.scalars("m");
  const ParticleId p = page.particle("\\alpha");
  const ParticleId q = page.particle("\\beta");
  CHECK(text(over(p, Term(m(p)))) == text(over(q, Term(m(q)))));
  CHECK(text(over(p, Term(m(p))) * over(q, Term(m(q)))) != text(over(p, pow(m(p), 2))));
}

TEST_CASE("equal terms are added up and powers joined, with the value kept") {
  Page page;
  const Named a = page.vector("a");
  const Named b = page.vector("b");
  const Named x = page.scalar("x");
  const std::vector<Term> all{
      dot(a + b, a - b),     dot(a, a) / pow(length(a), 3),     (x * x * x) / pow(x, 2),
      pow(length(a + b), 2), root(pow(x, 2)) * root(pow(x, 2)), dot(a, a) * length(a) / squared(a)};
  for (const Term& each : all) {
    const IndexPolynomial shorter = collected(page.tree, polynomial(each));
    CHECK(outcome(page, each, written(page, shorter)) == Outcome::proved);
  }
  CHECK(collected(page.tree, polynomial(dot(a + b, a - b))).terms.size() == 2);
  CHECK(collected(page.tree, polynomial(dot(a, a) / pow(length(a), 2))).terms.at(0).factors.empty());
}

TEST_CASE("more terms than may be multiplied out are no polynomial") {
  Page page;
  Term sum = page.scalar("x0");
  for (int k = 1; k < 30; ++k) sum = sum + page.scalar("x" + std::to_string(k));
  CHECK(polynomial_of(page.tree, sum.id));
  CHECK_FALSE(polynomial_of(page.tree, (sum * sum).id));
  CHECK_FALSE(polynomial_of(page.tree, page.number("123456789012345678901234567890").id));
}
