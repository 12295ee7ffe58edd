// SPDX-License-Identifier: GPL-3.0-or-later
// Wrong identities are told from laws: a law's symbols are listed, an identity has none.
#include "check/meaning/identity_reading.h"

#include "catch.h"
#include "expr/build.h"

namespace {

using namespace rigor;
using namespace rigor::build;

/// Some vectors and scalars, and the names of the symbols for which an equation is a law.
struct Equations : Page {
  Named a = vector("a");
  Named b = vector("b");
  Named c = vector("c");
  Named m = scalar("m");
  Named t = tensor("T");
  Named x = scalar("x");
  NameScope scope;

  std::string law(const Term& left, const Term& right, std::vector<IndexId> indices = {}) {
    std::string names;
    for (const SymbolId symbol : law_symbols(claim(left, right, std::move(indices)), scope))
      names += tree.symbols[symbol].name;
    return names;
  }
};

}  // namespace

TEST_CASE("an equation with the same symbols on both sides is an identity") {
  Equations on;
  CHECK(on.law(cross(on.a, on.b), cross(on.b, on.a)) == "");
  CHECK(on.law(dot(on.a, on.b), 2 * dot(on.b, on.a)) == "");
  CHECK(on.law(on.m * dot(on.a, on.b), dot(on.a, on.b) * on.m * on.m) == "");
}

TEST_CASE("an equation whose sides have symbols of their own is a law for these") {
  Equations on;
  CHECK(on.law(on.m * on.a, on.b) == "abm");
  CHECK(on.law(dot(on.a, on.b), dot(on.a, on.c)) == "bc");
}

TEST_CASE("a term too many on one side is a wrong identity") {
  Equations on;
  CHECK(on.law(dot(on.a, on.b), dot(on.b, on.a) + on.m) == "");
  CHECK(on.law(cross(on.a, on.b) + on.c, cross(on.b, on.a)) != "");
}

TEST_CASE("what one side has for itself inside a factor is no term too many") {
  Equations on;
  CHECK(on.law(dot(on.a, on.b + on.c), dot(on.a, on.b)) == "c");
  CHECK(on.law(dot(on.a + on.b, on.a + on.b), dot(on.a, on.a)) == "b");
}

TEST_CASE("terms that stand on both sides as they are say that the rest vanishes") {
  Equations on;
  CHECK(on.law(dot(on.a, on.b) + dot(on.a, on.c), dot(on.a, on.b)) == "c");
  CHECK(on.law(dot(on.a, on.b), dot(on.a, on.c) + dot(on.a, on.b)) == "c");
  CHECK(on.law(dot(on.a, on.b) + dot(on.a, on.c), -dot(on.a, on.b)) != "");
}

TEST_CASE("a factor on one side only is a law, since without it both sides vanish") {
  Equations on;
  CHECK(on.law(dot(on.a, on.b), on.m * dot(on.a, on.b)) == "m");
}

TEST_CASE("a sum of terms of one degree against zero is a wrong identity") {
  Equations on;
  const Term jacobi =
      cross(on.a, cross(on.b, on.c)) + cross(on.b, cross(on.c, on.a)) - cross(on.c, cross(on.a, on.b));
  CHECK(on.law(jacobi, on.zero()) == "");
  CHECK(on.law(on.zero(), dot(on.a, on.b) + dot(on.b, on.a)) == "ab");  // 2A·B = 0: they are orthogonal
}

TEST_CASE("one term against zero, or terms of several degrees, are a law") {
  Equations on;
  CHECK(on.law(dot(on.a, on.b), on.zero()) == "ab");
  CHECK(on.law(on.a + on.b, on.zero()) == "ab");
  CHECK(on.law(pow(on.x, 2) - 5 * on.x, on.zero()) == "x");
}

TEST_CASE("one symbol alone to the first power on both sides is a condition") {
  Equations on;
  const IndexId i = on.index("i");
  const IndexId j = on.index("j");
  CHECK(on.law(at(on.t, i, j), at(on.t, j, i), {i, j}) == "T");
  CHECK(on.law(on.x, 2 * on.x) == "x");
}

TEST_CASE("an equation in one scalar is to be solved, unless it holds at zero") {
  Equations on;
  CHECK(on.law(pow(on.x, 2), on.x + on.number("1")) == "x");
  CHECK(on.law(pow(on.x, 2), on.number("4")) == "x");
}

TEST_CASE("a defined symbol alone on the left side makes no condition of its definition") {
  Equations on;
  on.define(on.m, pow(on.x, 2));
  CHECK_FALSE(law_symbols(on.claim(on.m, pow(on.x, 2) + on.number("1")), on.scope).empty());
  CHECK(law_symbols(on.claim(on.m, pow(on.x, 2) + on.number("1")), on.scope, true).empty());
}

TEST_CASE("only what is said to be meant for all values is") {
  Equations on;
  for (const Named& named : {on.a, on.b, on.m}) mean_for_all(on.scope, named.symbol);
  CHECK(on.law(on.m * on.a, on.b) == "");
  CHECK(on.law(dot(on.a, on.b), on.zero()) == "");
  CHECK(on.law(on.m * on.a, on.c) == "c");
}

TEST_CASE("a defined symbol stands for what it is defined by") {
  Equations on;
  on.define(on.c, cross(on.a, on.b));
  CHECK(on.law(dot(on.c, on.c), dot(on.a, on.a) * dot(on.b, on.b)) == "");
  CHECK(primitive_symbols(on.question, Term(on.c).id) == std::vector<SymbolId>{on.a.symbol, on.b.symbol});
  CHECK(primitive_symbols(on.question, Term(on.m).id) == std::vector<SymbolId>{on.m.symbol});
}

TEST_CASE("an equation between numbers is no law") {
  Equations on;
  CHECK(on.law(on.number("2"), on.number("3")) == "");
}
