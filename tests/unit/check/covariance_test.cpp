// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/scope/covariance.h"

#include "catch.h"
#include "expr/build.h"

using namespace rigor;
using namespace rigor::build;

namespace {

class Turning : public Page {
 public:
  Names names;
  Named a = vector("a");
  Named b = vector("b");
  Named k = tensor("K");
  Named m = scalar("m");
  IndexId i = tree.add_index("i");
  IndexId j = tree.add_index("j");

  bool keeps_its_form(const Term& term, const std::vector<IndexId>& free = {}) {
    return is_covariant(tree, names, term.id, free);
  }
};

}  // namespace

TEST_CASE("vectors without axes keep their form along other axes") {
  Turning page;
  const Term a = page.a;
  const Term b = page.b;
  CHECK(page.keeps_its_form(cross(a, b) + a / squared(b)));
  CHECK(page.keeps_its_form(dot(page.k, a) - Term(page.m) * b));
  CHECK(page.keeps_its_form(sin(dot(a, b)) * length(a)));
  CHECK(page.keeps_its_form(page.number("0")));
  CHECK(page.keeps_its_form(tuple(page.number("0"), page.number("0"), page.number("0"))));
}

TEST_CASE("what names an axis does not") {
  Turning page;
  CHECK_FALSE(page.keeps_its_form(at(page.a, 1)));
  CHECK_FALSE(page.keeps_its_form(at(page.k, page.i, 3), {page.i}));
  CHECK_FALSE(page.keeps_its_form(page.basis(3)));
  CHECK_FALSE(page.keeps_its_form(Term(page.a) + tuple(page.m, page.number("0"), page.number("0"))));
  CHECK_FALSE(page.keeps_its_form(component(cross(page.a, page.b), 2)));
}

TEST_CASE("letters that are free once or summed in pairs name no axis") {
  Turning page;
  const auto& [i, j] = std::pair(page.i, page.j);
  CHECK(page.keeps_its_form(sum({j}, at(page.k, i, j) * at(page.a, j)), {i}));
  CHECK(page.keeps_its_form(sum({i}, pow(at(page.a, i), 2))));
  CHECK(page.keeps_its_form(at(page.a, i) * at(page.b, j) + at(page.k, j, i), {i, j}));
  CHECK(page.keeps_its_form(sum({i}, component(cross(page.a, page.b), i) * at(page.a, i))));
  CHECK_FALSE(page.keeps_its_form(at(page.a, i) * at(page.b, i), {i}));
  CHECK_FALSE(page.keeps_its_form(at(page.a, i) * at(page.b, j) + at(page.k, j, i), {i}));
  CHECK_FALSE(page.keeps_its_form(sum({i}, at(page.a, i))));
  CHECK_FALSE(page.keeps_its_form(sum({i}, pow(at(page.a, i), 3))));
  CHECK_FALSE(page.keeps_its_form(sum({i}, pow(at(page.a, i), 2) * at(page.b, i))));
  CHECK_FALSE(page.keeps_its_form(sum({i}, at(page.a, i) / at(page.b, i))));
  CHECK_FALSE(page.keeps_its_form(sum({i}, absolute(at(page.a, i)) * at(page.a, i))));
}

TEST_CASE("principal values belong to axes") {
  Turning page;
  const SymbolId values = resolve(page.names.symbols, page.tree, {"I", 1, false}, "I", {});
  const Named principal{&page.tree, values, no_particle};
  CHECK(page.keeps_its_form(at(principal, page.i), {page.i}));
  page.names.symbols.sightings.write().diagonal.insert("I");
  CHECK_FALSE(page.keeps_its_form(at(principal, page.i), {page.i}));
  CHECK_FALSE(page.keeps_its_form(at(page.derivative(principal, By::time), page.i), {page.i}));
}
