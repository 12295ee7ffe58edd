// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/tree/symbol.h"

#include "base/check.h"
#include "catch.h"

using namespace rigor;

TEST_CASE("a symbol is found by the id that it was given", "[expr]") {
  SymbolTable symbols;
  const SymbolId a = symbols.add({.name = "A", .rank = 1});
  const SymbolId i = symbols.add({.name = "I", .rank = 2, .symmetric = true});
  CHECK(symbols.size() == 2);
  CHECK(symbols[a].name == "A");
  CHECK(symbols[i].symmetric);
  symbols.write(a).declared = true;
  CHECK(symbols[a].declared);
}

TEST_CASE("a symbol stays where it is while others are added", "[expr]") {
  SymbolTable symbols;
  const Symbol& first = symbols[symbols.add({.name = "A"})];
  for (int k = 0; k < 1000; ++k) symbols.add({.name = "B"});
  CHECK(&first == &symbols[SymbolId{0}]);
}

TEST_CASE("what is made or changed in a copy of a table is not in the table", "[expr]") {
  SymbolTable symbols;
  const SymbolId a = symbols.add({.name = "A"});
  SymbolTable copy = symbols;
  copy.write(a).declared = true;
  const SymbolId rate = copy.derivative(a, By::time);
  CHECK_FALSE(symbols[a].declared);
  CHECK(symbols.size() == 1);
  CHECK_FALSE(symbols.has_derivatives(a));
  CHECK(copy.has_derivatives(a));
  CHECK(symbols.add({.name = "B"}) == rate);
  CHECK(copy[rate].derivation.has_value());
}

TEST_CASE("only a tensor of rank 2 is symmetric, only a vector has length 1", "[expr]") {
  SymbolTable symbols;
  CHECK_THROWS_AS(symbols.add({.name = "A", .rank = 1, .symmetric = true}), InternalError);
  CHECK_THROWS_AS(symbols.add({.name = "s", .rank = 0, .unit = true}), InternalError);
  CHECK_THROWS_AS(symbols.add({.name = "s", .rank = -1}), InternalError);
}

TEST_CASE("derivatives of a symbol commute and are made once", "[expr]") {
  SymbolTable symbols;
  const SymbolId a = symbols.add({.name = "A", .rank = 1, .per_particle = true});
  const SymbolId both = symbols.derivative(symbols.derivative(a, By::time), By::space);
  CHECK(symbols.derivative(symbols.derivative(a, By::space), By::time) == both);
  CHECK(symbols[both].rank == 2);
  CHECK(symbols[both].per_particle);
  CHECK(symbols.find({a, {By::time, By::space}}) == both);
  CHECK_FALSE(symbols.find({a, {By::time, By::time}}).has_value());
}

TEST_CASE("a derivative by a letter is by that letter only", "[expr]") {
  SymbolTable symbols;
  const SymbolId energy = symbols.add({.name = "L"});
  const SymbolId q = symbols.add({.name = "q"});
  const SymbolId by_place = symbols.derivative(energy, {By::letter, q});
  const SymbolId by_rate = symbols.derivative(energy, {By::letter, symbols.derivative(q, By::time)});
  CHECK(by_place != by_rate);
  CHECK(symbols[by_place].order() == 1);
  CHECK(symbols[by_place].order(By::time) == 0);
  CHECK(symbols[by_place].order({By::letter, q}) == 1);
  CHECK(symbols[by_rate].name == "\\partial_{\\dot{q}} L");
  CHECK(symbols[symbols.derivative(by_place, By::time)].name == "\\partial_{q} \\dot{L}");
}

TEST_CASE("a derivative is named as it is written, its label behind", "[expr]") {
  SymbolTable symbols;
  const SymbolId energy = symbols.add({.name = "T_{\\text{rot}}"});
  const SymbolId rate = symbols.derivative(energy, By::time);
  CHECK(symbols[rate].name == "\\dot{T}_{\\text{rot}}");
  CHECK(symbols[symbols.derivative(rate, By::time)].name == "\\ddot{T}_{\\text{rot}}");
  CHECK(symbols[symbols.derivative(energy, By::space)].name == "\\partial T_{\\text{rot}}");
}

TEST_CASE("a unit vector's rate is no unit vector, a symmetric tensor's is symmetric", "[expr]") {
  SymbolTable symbols;
  const SymbolId n = symbols.add({.name = "n", .rank = 1, .unit = true});
  const SymbolId i = symbols.add({.name = "I", .rank = 2, .symmetric = true});
  const SymbolId r = symbols.add({.name = "R", .rank = 2, .rotation = true});
  CHECK_FALSE(symbols[symbols.derivative(n, By::time)].unit);
  CHECK(symbols[symbols.derivative(i, By::time)].symmetric);
  CHECK_FALSE(symbols[symbols.derivative(r, By::time)].rotation);
}

TEST_CASE("components that exchange axes are one: of a symmetric tensor and of repeated ∂", "[expr]") {
  SymbolTable symbols;
  const SymbolId i = symbols.add({.name = "I", .rank = 2, .symmetric = true});
  const SymbolId a = symbols.add({.name = "A", .rank = 1});
  CHECK(canonical_component(symbols[i], 3 * 1 + 0) == 3 * 0 + 1);
  CHECK(canonical_component(symbols[a], 2) == 2);
  const SymbolId gradient = symbols.derivative(a, By::space);
  CHECK(canonical_component(symbols[gradient], 3 * 1 + 0) == 3 * 1 + 0);
  const SymbolId second = symbols.derivative(gradient, By::space);
  CHECK(canonical_component(symbols[second], 9 * 2 + 3 * 1 + 0) == 9 * 2 + 3 * 0 + 1);
  const SymbolId of_tensor = symbols.derivative(symbols.derivative(i, By::space), By::space);
  CHECK(canonical_component(symbols[of_tensor], 27 * 1 + 9 * 0 + 3 * 2 + 1) == 27 * 0 + 9 * 1 + 3 * 1 + 2);
}

TEST_CASE("orders do not wrap", "[expr]") {
  SymbolTable symbols;
  const SymbolId a = symbols.add({.name = "a"});
  SymbolId high = a;
  for (int k = 0; k < 300; ++k) high = symbols.derivative(high, By::time);
  CHECK(symbols[high].order(By::time) == 300);
  CHECK(symbols[high].order() == 300);
  for (int k = 300; k < largest_derivation; ++k) high = symbols.derivative(high, By::time);
  CHECK_THROWS_AS(symbols.derivative(high, By::time), InternalError);
}

TEST_CASE("a symmetric tensor of the plane has three numbers of its own", "[expr]") {
  const Symbol symbol{.name = "S", .rank = 2, .symmetric = true, .axes = AxisSpaces::of({2, 1}, 2)};
  CHECK(component_count(symbol) == 4);
  CHECK(canonical_component(symbol, 1) == 1);
  CHECK(canonical_component(symbol, 2) == 1);
  CHECK(canonical_component(symbol, 3) == 3);
}
