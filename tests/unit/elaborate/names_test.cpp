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
  CHECK_FALSE(find_symbol(names.symbols, vector_a).has_value());
  const SymbolId first = resolve(names.symbols, tree, vector_a, "\\mathbf{A}", {0, 3, 4});
  CHECK(resolve(names.symbols, tree, vector_a, "A", {}) == first);
  CHECK(tree.symbols[first].name == "\\mathbf{A}");
  CHECK(tree.symbols[first].rank == 1);
  CHECK(tree.symbols[first].first_seen == Span{0, 3, 4});
}

TEST_CASE("rank and particle are part of a name") {
  ExprTree tree;
  Names names;
  const SymbolId scalar = resolve(names.symbols, tree, scalar_a, "A", {});
  CHECK(resolve(names.symbols, tree, vector_a, "A", {}) != scalar);
  CHECK(resolve(names.symbols, tree, {"A", 0, true}, "A", {}) != scalar);
}

TEST_CASE("a declaration gives kind and properties, and is known by its directive") {
  ExprTree tree;
  Names names;
  Symbol unit = named("\\mathbf{n}");
  unit.unit = true;
  const SymbolId declared = declare(names, tree, {"n", 1, false}, unit, 7);
  CHECK(is_declared(names.symbols, {"n", 1, false}));
  CHECK_FALSE(is_declared(names.symbols, {"n", 0, false}));
  CHECK(tree.symbols[declared].unit);
  CHECK(tree.symbols[declared].declared);
  CHECK(declared_by(names.symbols, {"n", 1, false}) == 7u);
  CHECK(resolve(names.symbols, tree, {"n", 1, false}, "n", {}) == declared);
}

TEST_CASE("a declaration forgets the earlier symbol of its name") {
  ExprTree tree;
  Names names;
  const SymbolId before = resolve(names.symbols, tree, scalar_a, "A", {});
  mark_seen(names.scope, before);
  CHECK(declare(names, tree, scalar_a, named("A"), 0) != before);
  CHECK(resolve(names.symbols, tree, scalar_a, "A", {}) != before);
}

TEST_CASE("a declaration is of the symbol that only a directive spoke of") {
  ExprTree tree;
  Names names;
  const SymbolId before = resolve(names.symbols, tree, scalar_a, "A", {});
  CHECK(declare(names, tree, scalar_a, named("A"), 0) == before);
  CHECK(tree.symbols[before].declared);
  Symbol unit = named("\\mathbf{n}");
  unit.unit = true;
  const SymbolId plain = resolve(names.symbols, tree, {"n", 1, false}, "n", {});
  CHECK(declare(names, tree, {"n", 1, false}, unit, 1) != plain);
}

TEST_CASE("a declaration holds to the end of its section and in those inside it") {
  ExprTree tree;
  Names names;
  open_section(names, 1);
  declare(names, tree, scalar_a, named("A"), 0);
  declare_particles(names, "\\alpha", 1);
  open_section(names, 2);
  CHECK(is_declared(names.symbols, scalar_a));
  CHECK(labels_particles(names.symbols, "\\alpha"));
  declare(names, tree, vector_a, named("A"), 2);
  open_section(names, 2);
  CHECK_FALSE(is_declared(names.symbols, vector_a));
  CHECK(is_declared(names.symbols, scalar_a));
  open_section(names, 1);
  CHECK_FALSE(is_declared(names.symbols, scalar_a));
  CHECK_FALSE(labels_particles(names.symbols, "\\alpha"));
}

TEST_CASE("what is declared before the first heading holds everywhere") {
  ExprTree tree;
  Names names;
  declare(names, tree, scalar_a, named("A"), 0);
  open_section(names, 1);
  open_section(names, 1);
  CHECK(is_declared(names.symbols, scalar_a));
}

TEST_CASE("a definition by an equation outlives its section, one by a directive does not") {
  ExprTree tree;
  Names names;
  const SymbolId by_equation = resolve(names.symbols, tree, scalar_a, "A", {});
  const SymbolId by_directive = resolve(names.symbols, tree, vector_a, "A", {});
  open_section(names, 1);
  define(names.scope, definition_of(by_equation, std::nullopt));
  define(names.scope, definition_of(by_directive, 3));
  REQUIRE(definition_of(names.scope, by_directive) != nullptr);
  open_section(names, 1);
  CHECK(definition_of(names.scope, by_equation) != nullptr);
  CHECK(definition_of(names.scope, by_directive) == nullptr);
}

TEST_CASE("a second definition takes the place of the first") {
  ExprTree tree;
  Names names;
  const SymbolId symbol = resolve(names.symbols, tree, scalar_a, "A", {});
  define(names.scope, definition_of(symbol, 1));
  define(names.scope, definition_of(symbol, 2));
  CHECK(names.scope.definitions.size() == 1);
  CHECK(definition_of(names.scope, symbol)->origin.directive == 2u);
  forget_definition(names.scope, symbol);
  CHECK(definition_of(names.scope, symbol) == nullptr);
}

TEST_CASE("an assumption ends with its section") {
  ExprTree tree;
  Names names;
  open_section(names, 1);
  assume(names.scope, {});
  open_section(names, 2);
  assume(names.scope, {});
  CHECK(names.scope.assumptions.size() == 2);
  open_section(names, 2);
  CHECK(names.scope.assumptions.size() == 1);
  open_section(names, 1);
  CHECK(names.scope.assumptions.empty());
}

TEST_CASE("an assumption that no sample satisfies is remembered as such") {
  Names names;
  assume(names.scope, {});
  assume(names.scope, {});
  doubt_last_assumption(names.scope);
  CHECK_FALSE(names.scope.assumptions[0].without_sample);
  CHECK((names.scope.assumptions)[1].without_sample);
}

TEST_CASE("a vector declared by its plain letter is that letter while the declaration holds") {
  ExprTree tree;
  Names names;
  open_section(names, 1);
  declare(names, tree, vector_a, named("A"), 0);
  CHECK_FALSE(is_plain(names.symbols, vector_a));
  names.symbols.plain.write().insert(vector_a);
  CHECK(is_plain(names.symbols, vector_a));
  open_section(names, 1);
  CHECK_FALSE(is_plain(names.symbols, vector_a));
}

TEST_CASE("a symbol was seen in an equation of this section or one around it") {
  ExprTree tree;
  Names names;
  const SymbolId symbol = resolve(names.symbols, tree, scalar_a, "A", {});
  CHECK_FALSE(seen_in_equation(names.scope, symbol));
  open_section(names, 1);
  mark_seen(names.scope, symbol);
  open_section(names, 2);
  CHECK(seen_in_equation(names.scope, symbol));
  open_section(names, 1);
  CHECK_FALSE(seen_in_equation(names.scope, symbol));
}

TEST_CASE("a letter labels particles if a directive or a sum over it says so") {
  Names names;
  CHECK_FALSE(labels_particles(names.symbols, "\\alpha"));
  names.symbols.sightings.write().summed_greek.insert("\\alpha");
  CHECK(labels_particles(names.symbols, "\\alpha"));
  CHECK_FALSE(particles_declared_by(names.symbols, "\\alpha"));
  declare_particles(names, "n", 4);
  CHECK(labels_particles(names.symbols, "n"));
  CHECK(particles_declared_by(names.symbols, "n") == 4u);
}

TEST_CASE("the names for suggestions are those declared, defined or seen") {
  ExprTree tree;
  Names names;
  resolve(names.symbols, tree, scalar_a, "A", {});
  CHECK(known_names(names, tree).empty());
  declare(names, tree, {"B", 0, false}, named("B"), 0);
  mark_seen(names.scope, *find_symbol(names.symbols, scalar_a));
  CHECK(known_names(names, tree) == std::vector<std::string>{"A", "B"});
}

TEST_CASE("what is kept of a place answers as it did there, whatever is said later") {
  ExprTree tree;
  Names names;
  open_section(names, 1);
  const SymbolId symbol = declare(names, tree, scalar_a, named("A"), 0);
  define(names.scope, definition_of(symbol, 1));
  assume(names.scope, {});
  mean_for_all(names.scope, symbol);
  mark_seen(names.scope, symbol);
  declare_constant(names.scope, symbol, 2);
  const Names kept = names;
  declare_particles(names, "n", 3);
  names.symbols.sightings.write().places = true;
  names.symbols.evidence.write().operators = true;
  declare_small(names.scope, {});
  open_section(names, 1);
  CHECK_FALSE(is_declared(names.symbols, scalar_a));
  CHECK_FALSE(is_for_all(names.scope, symbol));
  CHECK(is_declared(kept.symbols, scalar_a));
  CHECK(definition_of(kept.scope, symbol) != nullptr);
  CHECK(kept.scope.assumptions.size() == 1);
  CHECK(is_for_all(kept.scope, symbol));
  CHECK(seen_in_equation(kept.scope, symbol));
  CHECK(change(kept, tree, symbol, By::time).directive == 2u);
  CHECK_FALSE(labels_particles(kept.symbols, "n"));
  CHECK_FALSE(kept.symbols.sightings->places);
  CHECK_FALSE(kept.symbols.evidence->operators);
  CHECK(kept.scope.small.empty());
}

TEST_CASE("entering a section copies nothing, and leaving one only what something goes from") {
  ExprTree tree;
  Names names;
  const SymbolId symbol = declare(names, tree, scalar_a, named("A"), 0);
  define(names.scope, definition_of(symbol, std::nullopt));
  mark_seen(names.scope, symbol);
  const Names before = names;
  open_section(names, 1);
  CHECK(&*names.symbols.keys.begin() == &*before.symbols.keys.begin());
  CHECK(&*names.scope.definitions.begin() == &*before.scope.definitions.begin());
  CHECK(&*names.scope.seen.begin() == &*before.scope.seen.begin());
  assume(names.scope, {});
  const Names inside = names;
  open_section(names, 1);
  CHECK(&*names.symbols.keys.begin() == &*before.symbols.keys.begin());
  CHECK(&*names.scope.definitions.begin() == &*before.scope.definitions.begin());
  CHECK(names.scope.assumptions.empty());
  CHECK(inside.scope.assumptions.size() == 1);
}

TEST_CASE("what is said of a symbol further out stays said behind a section that says it again") {
  NameScope scope;
  const SymbolId symbol{0};
  mean_for_all(scope, symbol);
  open_section(scope, 1);
  mean_for_all(scope, symbol);
  open_section(scope, 1);
  CHECK(is_for_all(scope, symbol));
}

TEST_CASE("behind a frame holds what held before it, and what equations defined in it") {
  NameScope scope;
  const SymbolId outside{0};
  const SymbolId inside{1};
  const SymbolId by_frame{2};
  define(scope, definition_of(outside, std::nullopt));
  const Held before = held(scope);
  open_section(scope, 1);
  enter_frame(scope, {"rot", "in", {}, {}, 4, 0, before});
  define(scope, definition_of(by_frame, 4));
  define(scope, definition_of(inside, std::nullopt));
  CHECK(is_made_in_frame(scope, *definition_of(scope, inside)));
  CHECK_FALSE(is_made_in_frame(scope, *definition_of(scope, by_frame)));
  open_section(scope, 1);
  CHECK(scope.frames->empty());
  CHECK(definition_of(scope, outside) != nullptr);
  CHECK(definition_of(scope, inside) != nullptr);
  CHECK(definition_of(scope, by_frame) == nullptr);
  CHECK(before.definitions.size() == 1);
}

TEST_CASE("who withdraws a constant is told which directives called it so") {
  NameScope scope;
  const SymbolId symbol{0};
  declare_constant(scope, symbol, 5);
  declare_constant(scope, SymbolId{1}, 6);
  CHECK(withdraw_constant(scope, symbol) == Directives{5});
  CHECK_FALSE(is_declared_constant(scope, symbol));
  CHECK(withdraw_constant(scope, symbol).empty());
}

TEST_CASE("a space that is named again is the same one, and another dimension is another space") {
  ExprTree tree;
  Names names;
  const auto entered = [&](const std::string& name, int dimension) {
    REQUIRE(enter_space(names, name, dimension, 0));
    return space_of(names.symbols);
  };
  const Space plane = entered("plane", 2);
  const Space solid = entered("plane", 3);
  CHECK(entered("plane", 3) == solid);
  CHECK(entered("plane", 2) == plane);
  const Space other = entered("other", 4);
  CHECK(solid.id != plane.id);
  CHECK(other.id != plane.id);
  CHECK(other.id != solid.id);
}
