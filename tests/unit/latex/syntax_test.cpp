// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/token/syntax.h"

#include <array>

#include "catch.h"
#include "latex/dump_syntax.h"

namespace {

using namespace rigor;

SyntaxId letter(SyntaxTree& tree, const char* name, Span span = {}) {
  WrittenSymbol symbol;
  symbol.letter = name;
  return tree.add_symbol(span, symbol);
}

}  // namespace

TEST_CASE("a node keeps its children in order, with what joins them") {
  SyntaxTree tree;
  const std::array children{SyntaxChild{letter(tree, "a")},
                            SyntaxChild{letter(tree, "b"), Joint::cross, {0, 1, 7}}};
  const SyntaxId term = tree.add(SyntaxKind::term, {0, 0, 8}, children);
  REQUIRE(tree.children(term).size() == 2);
  CHECK(tree.symbol(tree.child(term, 0)).letter == "a");
  CHECK(tree.children(term)[1].joint == Joint::cross);
  CHECK(tree.children(term)[1].joint_span == Span{0, 1, 7});
  CHECK(tree[term].span == Span{0, 0, 8});
  CHECK(tree.size() == 3);
}

TEST_CASE("a leaf has no children") {
  SyntaxTree tree;
  CHECK(tree.children(letter(tree, "a")).empty());
}

TEST_CASE("each kind of node gives back what was put in") {
  SyntaxTree tree;
  const SyntaxId two = tree.add_text(SyntaxKind::number, {}, "2");
  const SyntaxId words = tree.add_text(SyntaxKind::text, {}, "otherwise");
  const SyntaxId component = tree.add_component({}, two, {{"i", IndexForm::letter, 1, {}}});
  const SyntaxId sum = tree.add_big_sum({}, {{{"\\alpha", IndexForm::greek, 0, {}}}, "1", "N"}, two);
  const SyntaxId opaque = tree.add_opaque({}, {DiagnosticKind::unsupported, "not read", {"try this"}});
  CHECK(tree.text(two) == "2");
  CHECK(tree.text(words) == "otherwise");
  CHECK(tree.indices(component).at(0).primes == 1);
  CHECK(tree.big_sum(sum).indices.at(0).text == "\\alpha");
  CHECK(tree.big_sum(sum).to == "N");
  CHECK(tree.obstacle(opaque).message == "not read");
  CHECK(tree.obstacle(opaque).help.size() == 1);
  CHECK(tree.child(sum, 0) == two);
}

TEST_CASE("the payload of a matrix is its number of columns") {
  SyntaxTree tree;
  const SyntaxChild entry{letter(tree, "a")};
  const std::array entries{entry, entry, entry, entry};
  CHECK(tree[tree.add(SyntaxKind::matrix, {}, entries, 2)].payload == 2);
}

TEST_CASE("the dump shows faces, accents, primes and every form of index") {
  SyntaxTree tree;
  WrittenSymbol symbol;
  symbol.letter = "r";
  symbol.face = Face::vector;
  symbol.accent = Accent::hat;
  symbol.primes = 2;
  symbol.lower = {
      {"\\alpha", IndexForm::greek, 0, {}}, {"i", IndexForm::letter, 1, {}}, {"cm", IndexForm::word, 0, {}}};
  CHECK(dump_syntax(tree, tree.add_symbol({}, symbol)) == "vector:hat:r''[\\alpha,i',\"cm\"]");
}
