// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/name/names.h"

#include "catch.h"

namespace {

using namespace rigor;

const NameKey scalar_a{"A", 0, false};
const NameKey vector_a{"A", 1, false};

Symbol named(const char* name) {
  Symbol symbol;
  symbol.name = name;
  return symbol;
}

NamedDefinition definition_of(SymbolId symbol, std::optional<std::size_t> directive) {
  NamedDefinition named;
  named.definition.symbol = symbol;
  named.origin.directive = directive;
  return named;
}

}  // namespace

TEST_CASE("a symbol is made at first sight and found again") {
  ExprTree tree;
  Names names;
  CHECK_FALSE(names.find(vector_a).has_value());
  const SymbolId first = names.resolve(tree, vector_a, "\\mathbf{A}", {0, 3, 4});
  CHECK(names.resolve(tree, vector_a, "A", {}) == first);
  CHECK(tree.symbols[first].name == "\\mathbf{A}");
  CHECK(tree.symbols[first].rank == 1);
  CHECK(tree.symbols[first].first_seen == Span{0, 3, 4});
}

TEST_CASE("rank and particle are part of a name") {
  ExprTree tree;
  Names names;
  const SymbolId scalar = names.resolve(tree, scalar_a, "A", {});
  CHECK(names.resolve(tree, vector_a, "A", {}) != scalar);
  CHECK(names.resolve(tree, {"A", 0, true}, "A", {}) != scalar);
}

TEST_CASE("a declaration gives kind and properties, and counts as used when its symbol is") {
  ExprTree tree;
  Names names;
  Symbol unit = named("\\mathbf{n}");
  unit.unit = true;
  const SymbolId declared = names.declare(tree, {"n", 1, false}, unit, 7);
  CHECK(names.is_declared({"n", 1, false}));
  CHECK_FALSE(names.is_declared({"n", 0, false}));
  CHECK(tree.symbols[declared].unit);
  CHECK(tree.symbols[declared].declared);
  CHECK_FALSE(names.is_used(7));
  CHECK(names.resolve(tree, {"n", 1, false}, "n", {}) == declared);
  CHECK(names.is_used(7));
}

TEST_CASE("a declaration forgets the earlier symbol of its name") {
  ExprTree tree;
  Names names;
  const SymbolId before = names.resolve(tree, scalar_a, "A", {});
  names.mark_seen(before);
  CHECK(names.declare(tree, scalar_a, named("A"), 0) != before);
  CHECK(names.resolve(tree, scalar_a, "A", {}) != before);
}

TEST_CASE("a declaration is of the symbol that only a directive spoke of") {
  ExprTree tree;
  Names names;
  const SymbolId before = names.resolve(tree, scalar_a, "A", {});
  CHECK(names.declare(tree, scalar_a, named("A"), 0) == before);
  CHECK(tree.symbols[before].declared);
  Symbol unit = named("\\mathbf{n}");
  unit.unit = true;
  const SymbolId plain = names.resolve(tree, {"n", 1, false}, "n", {});
  CHECK(names.declare(tree, {"n", 1, false}, unit, 1) != plain);
}

TEST_CASE("a declaration holds to the end of its section and in those inside it") {
  ExprTree tree;
  Names names;
  names.open_section(tree.symbols, 1);
  names.declare(tree, scalar_a, named("A"), 0);
  names.declare_particles("\\alpha", 1);
  names.open_section(tree.symbols, 2);
  CHECK(names.is_declared(scalar_a));
  CHECK(names.labels_particles("\\alpha"));
  names.declare(tree, vector_a, named("A"), 2);
  names.open_section(tree.symbols, 2);
  CHECK_FALSE(names.is_declared(vector_a));
  CHECK(names.is_declared(scalar_a));
  names.open_section(tree.symbols, 1);
  CHECK_FALSE(names.is_declared(scalar_a));
  CHECK_FALSE(names.labels_particles("\\alpha"));
}

TEST_CASE("what is declared before the first heading holds everywhere") {
  ExprTree tree;
  Names names;
  names.declare(tree, scalar_a, named("A"), 0);
  names.open_section(tree.symbols, 1);
  names.open_section(tree.symbols, 1);
  CHECK(names.is_declared(scalar_a));
}

TEST_CASE("a definition by an equation outlives its section, one by a directive does not") {
  ExprTree tree;
  Names names;
  const SymbolId by_equation = names.resolve(tree, scalar_a, "A", {});
  const SymbolId by_directive = names.resolve(tree, vector_a, "A", {});
  names.open_section(tree.symbols, 1);
  names.define(definition_of(by_equation, std::nullopt));
  names.define(definition_of(by_directive, 3));
  REQUIRE(names.definition_of(by_directive) != nullptr);
  names.open_section(tree.symbols, 1);
  CHECK(names.definition_of(by_equation) != nullptr);
  CHECK(names.definition_of(by_directive) == nullptr);
}

TEST_CASE("a second definition takes the place of the first") {
  ExprTree tree;
  Names names;
  const SymbolId symbol = names.resolve(tree, scalar_a, "A", {});
  names.define(definition_of(symbol, 1));
  names.define(definition_of(symbol, 2));
  CHECK(names.definitions().size() == 1);
  CHECK(names.definition_of(symbol)->origin.directive == 2u);
  names.forget_definition(symbol);
  CHECK(names.definition_of(symbol) == nullptr);
}

TEST_CASE("an assumption ends with its section") {
  ExprTree tree;
  Names names;
  names.open_section(tree.symbols, 1);
  names.assume({});
  names.open_section(tree.symbols, 2);
  names.assume({});
  CHECK(names.assumptions().size() == 2);
  names.open_section(tree.symbols, 2);
  CHECK(names.assumptions().size() == 1);
  names.open_section(tree.symbols, 1);
  CHECK(names.assumptions().empty());
}

TEST_CASE("an assumption that no sample satisfies is remembered as such") {
  Names names;
  names.assume({});
  names.assume({});
  names.doubt_last_assumption();
  CHECK_FALSE(names.assumptions()[0].without_sample);
  CHECK(names.assumptions()[1].without_sample);
}

TEST_CASE("a vector declared by its plain letter is that letter while the declaration holds") {
  ExprTree tree;
  Names names;
  names.open_section(tree.symbols, 1);
  names.declare(tree, vector_a, named("A"), 0);
  CHECK_FALSE(names.is_plain(vector_a));
  names.declare_plain(vector_a);
  CHECK(names.is_plain(vector_a));
  names.open_section(tree.symbols, 1);
  CHECK_FALSE(names.is_plain(vector_a));
}

TEST_CASE("a symbol was seen in an equation of this section or one around it") {
  ExprTree tree;
  Names names;
  const SymbolId symbol = names.resolve(tree, scalar_a, "A", {});
  CHECK_FALSE(names.seen_in_equation(symbol));
  names.open_section(tree.symbols, 1);
  names.mark_seen(symbol);
  names.open_section(tree.symbols, 2);
  CHECK(names.seen_in_equation(symbol));
  names.open_section(tree.symbols, 1);
  CHECK_FALSE(names.seen_in_equation(symbol));
}

TEST_CASE("a letter labels particles if a directive or a sum over it says so") {
  Names names;
  CHECK_FALSE(names.is_particle_letter("\\alpha"));
  names.sightings.summed_greek.insert("\\alpha");
  CHECK(names.is_particle_letter("\\alpha"));
  names.declare_particles("n", 4);
  CHECK(names.labels_particles("n"));
  CHECK_FALSE(names.is_used(4));
  CHECK(names.is_particle_letter("n"));
  CHECK(names.is_used(4));
}

TEST_CASE("the names for suggestions are those declared, defined or seen") {
  ExprTree tree;
  Names names;
  names.resolve(tree, scalar_a, "A", {});
  CHECK(names.known_names(tree).empty());
  names.declare(tree, {"B", 0, false}, named("B"), 0);
  names.mark_seen(*names.find(scalar_a));
  CHECK(names.known_names(tree) == std::vector<std::string>{"A", "B"});
}
