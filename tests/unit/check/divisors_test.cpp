// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/meaning/divisors.h"

#include "catch.h"

namespace rigor {
namespace {

struct Divided {
  ExprTree tree;
  Names names;
  SymbolId a = symbol("a");
  SymbolId k = symbol("k");
  SymbolId u = symbol("u");

  Divided() {
    const ExprId square = node({.op = Op::power, .exponent = 2}, {of(k)});
    define(names.scope,
           {.definition = {.symbol = u, .body = node({.op = Op::divide}, {of(a), square})}, .origin = {}});
  }
  SymbolId symbol(const char* name) { return tree.symbols.add({.name = name}); }
  ExprId of(SymbolId symbol) { return tree.add({.op = Op::symbol, .symbol = symbol}); }
  ExprId node(ExprNode node, const std::vector<ExprId>& children) { return tree.add(node, children); }
  std::vector<SymbolId> divisors(const char* a_value, const char* k_value) const {
    Sample sample;
    sample.values = {{.symbol = a, .components = {a_value}}, {.symbol = k, .components = {k_value}}};
    return divisors_of_sample(tree, names, sample);
  }
};

}  // namespace

TEST_CASE("a factor of a divisor in force that is 0 on a sample is found, and no dividend") {
  const Divided divided;
  CHECK(divided.divisors("1", "0") == std::vector<SymbolId>{divided.k});
  CHECK(divided.divisors("0", "0") == std::vector<SymbolId>{divided.k});
  CHECK(divided.divisors("0", "1").empty());
  CHECK(divided.divisors("1", "1").empty());
}

}  // namespace rigor
