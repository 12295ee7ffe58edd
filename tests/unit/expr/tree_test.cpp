// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/tree/tree.h"

#include "base/check.h"
#include "catch.h"
#include "expr/build.h"

using namespace rigor;
using namespace rigor::build;

TEST_CASE("a node keeps its children, slots and span", "[expr]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const Term product = dot(a, b);
  REQUIRE(page.tree.children(product.id).size() == 2);
  CHECK(page.tree[page.tree.children(product.id)[1]].symbol == b.symbol);
  CHECK(page.tree[product.id].rank == 0);

  const IndexId i = page.index("i");
  const Term component = at(a, i);
  REQUIRE(page.tree.slots(component.id).size() == 1);
  CHECK(page.tree.slots(component.id)[0].variable == i);
  CHECK(page.tree.slots(at(a, 3).id)[0].axis == 3);

  const ExprId two = page.tree.add_number({.file = 1, .begin = 4, .end = 5}, "2");
  CHECK(page.tree.digits(two) == "2");
  CHECK(page.tree[two].span == Span{1, 4, 5});
}

TEST_CASE("a rank that does not follow from the children is our own bug", "[expr]") {
  Page page;
  const Named a = page.vector("A");
  const Named s = page.scalar("s");
  const Named m = page.scalars("m");
  const IndexId i = page.index("i");

  CHECK_THROWS_AS(node(Op::add, {a, s}, 1), InternalError);
  CHECK_THROWS_AS(node(Op::dot, {a, s}, 0), InternalError);
  CHECK_THROWS_AS(node(Op::cross, {a, a}, 0), InternalError);
  CHECK_THROWS_AS(node(Op::divide, {s, a}, 0), InternalError);
  CHECK_THROWS_AS(node(Op::power, {a}, 0), InternalError);
  CHECK_THROWS_AS(node(Op::length, {s}, 0), InternalError);
  CHECK_THROWS_AS(node(Op::negate, {a, a}, 1), InternalError);
  CHECK_THROWS_AS(node(Op::number, {a}, 1), InternalError);
  CHECK_THROWS_AS(at(a, i, i), InternalError);
  CHECK_THROWS_AS(at(a, 4), InternalError);
  CHECK_THROWS_AS(component(a, 1, 2), InternalError);
  CHECK_THROWS_AS(static_cast<Term>(m), InternalError);  // a particle's quantity without its particle
  CHECK_THROWS_AS(page.determinant({a, a, a}), InternalError);
  CHECK_THROWS_AS(page.tree.add_number({}, "1.2.3"), InternalError);
  CHECK_THROWS_AS(page.tree.add_number({}, "."), InternalError);
}

TEST_CASE("a determinant has nine scalars, or one row of vectors", "[expr]") {
  Page page;
  const Named a = page.vector("A");
  const Named b = page.vector("B");
  const std::vector<Term> row_a{at(a, 1), at(a, 2), at(a, 3)};
  const std::vector<Term> row_b{at(b, 1), at(b, 2), at(b, 3)};
  const std::vector<Term> row_e{page.basis(1), page.basis(2), page.basis(3)};
  const auto rows = [](const std::vector<Term>& x, const std::vector<Term>& y, const std::vector<Term>& z) {
    std::vector<Term> all = x;
    all.insert(all.end(), y.begin(), y.end());
    all.insert(all.end(), z.begin(), z.end());
    return all;
  };
  CHECK(page.determinant(rows(row_a, row_b, row_a)).rank() == 0);
  CHECK(page.determinant(rows(row_e, row_a, row_b)).rank() == 1);
  CHECK_THROWS_AS(page.determinant(rows(row_e, row_e, row_b)), InternalError);
}

TEST_CASE("a table has an entry for each tuple of its slots", "[expr]") {
  Page page;
  const IndexId i = page.index("i");
  const std::vector<ExprId> values{page.number("0").id, page.number("1").id};
  const std::vector<Slot> slots{Place(i).slot};
  CHECK(page.tree[page.tree.add_table({}, values, slots, {{0, 1, 1}})].rank == 0);
  CHECK_THROWS_AS(page.tree.add_table({}, values, slots, {{0, 1}}), InternalError);
  CHECK_THROWS_AS(page.tree.add_table({}, values, slots, {{0, 1, 2}}), InternalError);
}

TEST_CASE("a literal zero is known as such", "[expr]") {
  Page page;
  CHECK(page.tree.is_zero_literal(page.number("0").id));
  CHECK(page.tree.is_zero_literal(page.number("0.00").id));
  CHECK_FALSE(page.tree.is_zero_literal(page.number("10").id));
  CHECK_FALSE(page.tree.is_zero_literal(static_cast<Term>(page.scalar("s")).id));
}

TEST_CASE("the axes of a value follow from what it is made of", "[expr]") {
  constexpr Space plane{2, 1};
  ExprTree tree;
  const SymbolId a = tree.symbols.add({.name = "a", .rank = 1, .axes = AxisSpaces::of(plane, 1)});
  const SymbolId b = tree.symbols.add({.name = "b", .rank = 1});
  const ExprId flat = tree.add({.op = Op::symbol, .rank = 1, .symbol = a});
  const ExprId common = tree.add({.op = Op::symbol, .rank = 1, .symbol = b});
  CHECK(component_count(tree[flat]) == 2);
  CHECK(component_count(tree[common]) == 3);
  const ExprId factors[] = {flat, common};
  const ExprId dyad = tree.add({.op = Op::multiply, .rank = 2}, factors);
  CHECK(component_count(tree[dyad]) == 6);
  CHECK(tree[dyad].axes[0] == plane);
  CHECK(tree[dyad].axes[1] == common_space);
  const ExprId contracted[] = {dyad, common};
  CHECK(tree[tree.add({.op = Op::dot, .rank = 1}, contracted)].axes[0] == plane);
  CHECK(is_of_common_space(tree, common));
  CHECK_FALSE(is_of_common_space(tree, dyad));
}

TEST_CASE("values of different spaces are neither added nor multiplied into each other", "[expr]") {
  constexpr Space plane{2, 1};
  ExprTree tree;
  const SymbolId a = tree.symbols.add({.name = "a", .rank = 1, .axes = AxisSpaces::of(plane, 1)});
  const SymbolId b = tree.symbols.add({.name = "b", .rank = 1});
  const ExprId flat = tree.add({.op = Op::symbol, .rank = 1, .symbol = a});
  const ExprId common = tree.add({.op = Op::symbol, .rank = 1, .symbol = b});
  const ExprId both[] = {flat, common};
  CHECK_THROWS_AS(tree.add({.op = Op::add, .rank = 1}, both), InternalError);
  CHECK_THROWS_AS(tree.add({.op = Op::dot}, both), InternalError);
  const ExprId twice[] = {flat, flat};
  CHECK_THROWS_AS(tree.add({.op = Op::cross, .rank = 1}, twice), InternalError);
  const Slot third{3, {}};
  CHECK_THROWS_AS(tree.add({.op = Op::symbol, .symbol = a}, {}, std::span(&third, 1)), InternalError);
  const Slot of_common{0, tree.add_index("i")};
  CHECK_THROWS_AS(tree.add({.op = Op::symbol, .symbol = a}, {}, std::span(&of_common, 1)), InternalError);
}
