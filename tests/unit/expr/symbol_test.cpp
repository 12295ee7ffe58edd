// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/symbol.h"

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
  symbols[a].declared = true;
  CHECK(symbols[a].declared);
}

TEST_CASE("only a tensor of rank 2 is symmetric, only a vector has length 1", "[expr]") {
  SymbolTable symbols;
  CHECK_THROWS_AS(symbols.add({.name = "A", .rank = 1, .symmetric = true}), InternalError);
  CHECK_THROWS_AS(symbols.add({.name = "s", .rank = 0, .unit = true}), InternalError);
  CHECK_THROWS_AS(symbols.add({.name = "s", .rank = -1}), InternalError);
}
