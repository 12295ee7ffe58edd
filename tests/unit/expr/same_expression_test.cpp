// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/tree/same_expression.h"

#include "catch.h"
#include "expr/build.h"

using namespace rigor;
using namespace rigor::build;

namespace {

bool are_same(const Term& a, const Term& b) { return same_expression(*a.tree, a.id, *b.tree, b.id); }
bool are_alike(const Term& a, const Term& b) { return (*a.tree)[a.id].likeness == (*b.tree)[b.id].likeness; }

}  // namespace

TEST_CASE("what the notation cannot say makes no difference, nor to the likeness", "[expr]") {
  Page page;
  const Named a = page.vector("A");
  const Named s = page.scalar("s");
  const Named u = page.scalar("u");
  const IndexId i = page.index("i");
  const IndexId j = page.index("j");
  const Term zero = number_like(s, "0");
  const std::vector<std::pair<Term, Term>> pairs{
      {s * u, s * u},
      {s * (u * a), (s * u) * a},
      {(s * a) * u, (s * u) * a},
      {pow(s, 1) * u, s * u},
      {pow(s * u, 1) * u, (s * u) * u},
      {component(a, 2), at(a, 2)},
      {sum({i}, at(a, i) * s), sum({j}, at(a, j) * s)},
      {sum({i, j}, at(a, i) * at(a, j)), sum({j, i}, at(a, i) * at(a, j))},
      {zero, number_like(s, "0.0")},
      {s + zero, s + number_like(s, "0.0")},
  };
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    CAPTURE(k);
    CHECK(are_same(pairs[k].first, pairs[k].second));
    CHECK(are_alike(pairs[k].first, pairs[k].second));
  }
}

TEST_CASE("other expressions differ, most of them in their likeness", "[expr]") {
  Page page;
  const Named a = page.vector("A");
  const Named s = page.scalar("s");
  const Named u = page.scalar("u");
  const std::vector<std::pair<Term, Term>> pairs{
      {s * u, s + u},           {pow(s, 2), pow(s, 3)},
      {pow(s, 2), s * s},       {s - u, u - s},
      {s / u, u / s},           {at(a, 1), at(a, 2)},
      {2 * s, 3 * s},           {function(Function::sin, s), function(Function::cos, s)},
      {dot(a, a), cross(a, a)},
  };
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    CAPTURE(k);
    CHECK_FALSE(are_same(pairs[k].first, pairs[k].second));
    CHECK_FALSE(are_alike(pairs[k].first, pairs[k].second));
  }
  CHECK(are_alike(s * u, u * s));
  CHECK_FALSE(are_same(s * u, u * s));
}

TEST_CASE("expressions of different trees are compared by the names of their symbols", "[expr]") {
  Page page;
  Page other;
  const Named u = page.scalar("u");
  const Named s = page.scalar("s");
  const Named other_s = other.scalar("s");
  const Named other_u = other.scalar("u");
  CHECK(are_same(s * u, other_s * other_u));
  CHECK_FALSE(are_same(s * u, other_u * other_s));
}
