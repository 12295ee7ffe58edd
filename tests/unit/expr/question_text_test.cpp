// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/statement/question_text.h"

#include "catch.h"

namespace rigor {
namespace {

/// a_i b_i = c, with `before` symbols and nodes that nothing reaches.
struct Built {
  ExprTree tree;
  Question question;
};

ExprId symbol_node(ExprTree& tree, SymbolId id) {
  const auto rank = static_cast<std::uint8_t>(tree.symbols[id].rank);
  return tree.add({.op = Op::symbol, .rank = rank, .symbol = id});
}

void build(Built& built, int before, const char* name = "a", int rank = 1) {
  ExprTree& tree = built.tree;
  for (int k = 0; k < before; ++k) {
    tree.symbols.add({.name = "x"});
    tree.add_index("k");
    tree.add_number({}, "3");
  }
  const SymbolId a = tree.symbols.add({.name = name, .rank = rank});
  const SymbolId b = tree.symbols.add({.name = "b", .rank = rank});
  const SymbolId c = tree.symbols.add({.name = "c"});
  const ExprId sides[] = {symbol_node(tree, a), symbol_node(tree, b)};
  const ExprId left = tree.add({.op = rank == 1 ? Op::dot : Op::multiply}, sides);
  const ExprId right =
      tree.add({.op = Op::symbol, .span = {0, static_cast<std::uint32_t>(before), 9}, .symbol = c});
  built.question.tree = &tree;
  built.question.claim = {left, right};
}

std::string text_of(int before, const char* name = "a", int rank = 1) {
  Built built;
  build(built, before, name, rank);
  return question_text(built.question).text;
}

TEST_CASE("neither ids nor places are in the text of a question") { CHECK(text_of(0) == text_of(5)); }

TEST_CASE("whatever the exact side sees changes the text") {
  const std::string plain = text_of(0);
  CHECK(plain != text_of(0, "d"));
  CHECK(plain != text_of(0, "a", 0));
  const auto changed = [](const auto& change) {
    Built built;
    build(built, 0);
    change(built.tree, built.question);
    return question_text(built.question).text;
  };
  const SymbolId a{0};
  CHECK(plain != changed([&](ExprTree& tree, Question&) { tree.symbols[a].unit = true; }));
  CHECK(plain != changed([&](ExprTree& tree, Question&) { tree.symbols[a].per_particle = true; }));
  CHECK(plain != changed([&](ExprTree& tree, Question&) { tree.symbols[a].declared = true; }));
  CHECK(plain != changed([&](ExprTree&, Question& question) { question.zeroed = {a}; }));
  CHECK(plain != changed([&](ExprTree&, Question& question) { question.claim.relation = Relation::less; }));
  CHECK(plain != changed([&](ExprTree&, Question& question) { question.assumptions = {question.claim}; }));
  CHECK(plain != changed([&](ExprTree&, Question& question) {
          std::swap(question.claim.left, question.claim.right);
        }));
  const auto defined = [&](bool by_square) {
    return changed([&](ExprTree&, Question& question) {
      question.definitions = {{SymbolId{2}, {}, no_particle, question.claim.left, by_square}};
    });
  };
  CHECK(plain != defined(false));
  CHECK(defined(true) != defined(false));
}

TEST_CASE("symbols are numbered in the order of their ids, the base of a derivative among them") {
  Built built;
  build(built, 2);
  const SymbolId rate = built.tree.symbols.derivative(SymbolId{2}, By::time);
  built.question.claim.right = built.tree.add({.op = Op::symbol, .rank = 1, .symbol = rate});
  const QuestionText asked = question_text(built.question, std::vector<SymbolId>{SymbolId{0}});
  CHECK(asked.symbols == std::vector<SymbolId>{SymbolId{0}, SymbolId{2}, SymbolId{3}, rate});
  CHECK(asked.number_of.at(rate) == 3);
}

}  // namespace
}  // namespace rigor
