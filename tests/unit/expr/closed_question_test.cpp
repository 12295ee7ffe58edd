// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/statement/closed_question.h"

#include "catch.h"
#include "expr/statement/archived.h"

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

std::string bytes_of(int before, const char* name = "a", int rank = 1) {
  Built built;
  build(built, before, name, rank);
  return archived(closed(built.question));
}

TEST_CASE("a closed question has neither the ids nor the places of the notes") {
  CHECK(bytes_of(0) == bytes_of(5));
}

TEST_CASE("whatever the exact side sees changes a closed question") {
  const std::string plain = bytes_of(0);
  CHECK(plain != bytes_of(0, "d"));
  CHECK(plain != bytes_of(0, "a", 0));
  const auto changed = [](const auto& change) {
    Built built;
    build(built, 0);
    change(built.tree, built.question);
    return archived(closed(built.question));
  };
  const SymbolId a{0};
  CHECK(plain != changed([&](ExprTree& tree, Question&) { tree.symbols.write(a).unit = true; }));
  CHECK(plain !=
        changed([&](ExprTree& tree, Question&) { tree.symbols.write(a).unit_of_measure.emplace(); }));
  CHECK(plain != changed([&](ExprTree& tree, Question&) { tree.symbols.write(a).declared = true; }));
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

TEST_CASE("a closed question has what it reaches and nothing else, in the order of the notes") {
  Built built;
  build(built, 2);
  const SymbolId acceleration =
      built.tree.symbols.derivative(built.tree.symbols.derivative(SymbolId{2}, By::time), By::time);
  built.question.claim.right = built.tree.add({.op = Op::symbol, .rank = 1, .symbol = acceleration});
  const ClosedQuestion asked = closed(built.question, std::vector<SymbolId>{SymbolId{0}});
  CHECK(asked.symbols == std::vector<SymbolId>{SymbolId{0}, SymbolId{2}, acceleration, SymbolId{3}});
  CHECK(asked.tree->symbols.size() == 4);
  CHECK(asked.tree->size() == 4);
  CHECK(asked.tree->index_count() == 0);
  CHECK(number_of(asked, acceleration) == SymbolId{2});
  CHECK_FALSE(number_of(asked, SymbolId{1}));
  CHECK(asked.tree->symbols[SymbolId{2}].derivation->base == SymbolId{1});
  CHECK(dump(*asked.tree, asked.question.claim.left) == dump(built.tree, built.question.claim.left));
}

TEST_CASE("which derivatives were asked for before does not show in a closed question") {
  const auto with_rates = [](bool other_first) {
    Built built;
    build(built, 0);
    SymbolTable& symbols = built.tree.symbols;
    if (other_first) static_cast<void>(symbols.derivative(SymbolId{1}, By::time));
    const SymbolId first = symbols.derivative(SymbolId{0}, By::time);
    const SymbolId second = symbols.derivative(SymbolId{1}, By::time);
    const ExprId sides[] = {symbol_node(built.tree, first), symbol_node(built.tree, second)};
    built.question.claim.left = built.tree.add({.op = Op::dot}, sides);
    return archived(closed(built.question));
  };
  CHECK(with_rates(false) == with_rates(true));
}

TEST_CASE("a closed question has the letters that are differentiated by, and they are archived") {
  Built built;
  build(built, 1);
  SymbolTable& symbols = built.tree.symbols;
  const SymbolId rate = symbols.derivative(SymbolId{2}, By::time);
  const SymbolId slope = symbols.derivative(SymbolId{0}, {By::letter, rate});
  const auto asked_of = [&](SymbolId symbol) {
    built.question.claim.left = built.question.claim.right = symbol_node(built.tree, symbol);
    return closed(built.question);
  };
  const ClosedQuestion asked = asked_of(slope);
  CHECK(asked.symbols == std::vector<SymbolId>{SymbolId{0}, slope, SymbolId{2}, rate});
  CHECK(asked.tree->symbols[SymbolId{1}].order({By::letter, SymbolId{3}}) == 1);
  CHECK(archived(asked) != archived(asked_of(symbols.derivative(SymbolId{0}, {By::letter, SymbolId{2}}))));
  const auto back = question_of_bytes(archived(asked));
  REQUIRE(back);
  CHECK(archived(*back) == archived(asked));
}

TEST_CASE("a closed question stays the same when the notes go on") {
  Built built;
  build(built, 0);
  const ClosedQuestion asked = closed(built.question);
  const std::string before = archived(asked);
  built.tree.symbols.write(SymbolId{0}).name = "changed";
  for (int k = 0; k < 100; ++k) built.tree.add_number({}, "1");
  CHECK(archived(asked) == before);
}

TEST_CASE("an answer speaks of the symbols of the notes, and a sample of the notes is taken over") {
  Built built;
  build(built, 4);
  const ClosedQuestion asked = closed(built.question);
  Decision decision;
  decision.unfolded = {SymbolId{1}};
  decision.sample.emplace().values = {{SymbolId{2}, 0, {"7"}}};
  const Decision answer = in_notes(decision, asked);
  CHECK(answer.unfolded == std::vector<SymbolId>{SymbolId{5}});
  CHECK(answer.sample->values[0].symbol == SymbolId{6});
  Sample known = *answer.sample;
  known.values.push_back({SymbolId{0}, 0, {"1"}});
  const Sample there = in_question(known, asked);
  REQUIRE(there.values.size() == 1);
  CHECK(there.values[0].symbol == SymbolId{2});
}

TEST_CASE("a question and its answer come back from their bytes") {
  Built built;
  build(built, 3);
  built.question.assumptions = {built.question.claim};
  built.question.definitions = {{SymbolId{5}, {}, no_particle, built.question.claim.left, true}};
  const std::string bytes = archived(closed(built.question));
  const auto back = question_of_bytes(bytes);
  REQUIRE(back);
  CHECK(archived(*back) == bytes);
  for (std::size_t size = 0; size < bytes.size(); ++size)
    CHECK_FALSE(question_of_bytes(std::string_view(bytes).substr(0, size)));
  Decision decision;
  decision.outcome = Outcome::refuted;
  decision.sample.emplace().values = {{SymbolId{2}, 1, {"-7/2", "0"}}};
  const auto answer = decision_of_bytes(archived(decision));
  REQUIRE(answer);
  CHECK(archived(*answer) == archived(decision));
  CHECK(answer->sample->values[0].components == std::vector<std::string>{"-7/2", "0"});
}

TEST_CASE("bytes whose ids name nothing are refused") {
  Built built;
  build(built, 0);
  ClosedQuestion asked = closed(built.question);
  asked.question.zeroed = {SymbolId{3}};
  CHECK_FALSE(question_of_bytes(archived(asked)));
  asked.question.zeroed = {SymbolId{2}};
  CHECK(question_of_bytes(archived(asked)));
  asked.question.claim.left = static_cast<ExprId>(asked.tree->size());
  CHECK_FALSE(question_of_bytes(archived(asked)));
}

}  // namespace
}  // namespace rigor
