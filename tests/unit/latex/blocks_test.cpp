// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/split/blocks.h"

#include "catch.h"
#include "latex/dump_syntax.h"

namespace {

using namespace rigor;

std::string statement(const std::string& text) {
  Stretch stretch(text);
  return dump_chains(split_statement(stretch.tokens, stretch.uses));
}

RelationKind first_relation(const std::string& text) {
  Stretch stretch(text);
  return split_statement(stretch.tokens, stretch.uses).at(0).relations.at(0).kind;
}

template <class Question>
bool ask(Question question, const std::string& text) {
  const Stretch stretch(text);
  return question(TokenView(stretch.tokens));
}

}  // namespace

TEST_CASE("several equations on a line are told apart by space, words and commas") {
  CHECK(statement("a = b \\quad c = d \\qquad e = f") == "a = b // c = d // e = f");
  CHECK(statement("a = b, \\quad c = d.") == "a = b // c = d");
  CHECK(statement("a = b \\quad\\text{and}\\quad c = d") == "a = b // c = d");
  CHECK(statement("a = b \\mbox{ or } c = d") == "a = b // c = d");
  CHECK(statement("a = b, c = d; e = f") == "a = b // c = d // e = f");
}

TEST_CASE("a comma between things that are no equations separates nothing") {
  CHECK(statement("x, y = 1") == "x, y = 1");
  CHECK(statement("v = (1, 2, 3)") == "v = (1, 2, 3)");
  CHECK(statement("x = 1, 2") == "x = 1, 2");
}

TEST_CASE("a wide space inside a chain separates nothing") {
  CHECK(statement("a \\quad = b") == "a = b");
  CHECK(statement("a = \\quad b") == "a = b");
  CHECK(statement("a = b \\quad = c") == "a = b = c");
  CHECK(statement("a = b \\quad + c") == "a = b + c");
}

TEST_CASE("a number in brackets behind space is the tag") {
  CHECK(statement("a = b \\quad (6)") == "a = b [(6)]");
  CHECK(statement("a = b \\qquad (2.3a)") == "a = b [(2.3a)]");
  CHECK(statement("a = b \\quad (A1')") == "a = b [(A1')]");
  CHECK(statement("a = b, \\quad c = d \\quad (6)") == "a = b [(6)] // c = d [(6)]");
}

TEST_CASE("a number in brackets without space before it is a factor") {
  CHECK(statement("a = b (6)") == "a = b (6)");
  CHECK(statement("a = b(6) = c") == "a = b(6) = c");
}

TEST_CASE("a range of index values says nothing new") {
  CHECK(statement("a_i = b_i, \\quad i = 1,2,3") == "a_i = b_i");
  CHECK(statement("a_i = b_i \\quad (i = 1, 2, 3)") == "a_i = b_i");
  CHECK(statement("a_i = b_i, i = 1,2,3") == "a_i = b_i");
  CHECK(statement("T_{ij} = T_{ji}, \\qquad i,j = 1, 2, 3.") == "T_{ij} = T_{ji}");
  CHECK(statement("a_i = b_i \\quad i = x, y, z") == "a_i = b_i");
  CHECK(statement("a_i = b_i \\quad i = 1, \\ldots, 3") == "a_i = b_i");
}

TEST_CASE("a range that is not that of all axes is no remark") {
  CHECK(statement("a_i = b_i \\quad i = 1, 2") != "a_i = b_i");
}

TEST_CASE("a condition on the indices restricts the equation") {
  CHECK(statement("a_i = b_i \\quad i \\ne j") == "a_i = b_i ~restricted");
  CHECK(statement("a_i = b_i \\quad (i = j)") == "a_i = b_i ~restricted");
  CHECK(statement("a_i = b_i, i < j") == "a_i = b_i ~restricted");
  CHECK(statement("a_i = b_i \\quad\\text{if } i \\ne j") == "a_i = b_i ~restricted");
}

TEST_CASE("values that a letter takes restrict the equation") {
  CHECK(statement("k = n\\pi, \\quad n = 1, 2, \\dots") == "k = n\\pi ~restricted");
  CHECK(statement("k = n\\pi \\quad (n \\in \\mathbb{Z}),") == "k = n\\pi ~restricted");
}

TEST_CASE("words that can only restrict an equation leave it to be proved") {
  for (const char* words : {"if B is constant", "when at rest", "for small a", "to first order", "nearly"}) {
    INFO(words);
    CHECK(statement(std::string("a = b \\quad\\text{") + words + "}") == "a = b ~restricted");
    CHECK(statement(std::string("a = b \\quad (\\text{") + words + "})") == "a = b ~restricted");
  }
}

TEST_CASE("words that may change an equation leave it unjudged") {
  for (const char* words : {"is not true", "no sum if b is zero", "times two", "or not", "wrong", "lb"}) {
    INFO(words);
    CHECK(statement(std::string("a = b \\quad\\text{") + words + "}") == "a = b ?unsupported");
  }
}

TEST_CASE("words can take the sum from an equation") {
  for (const char* words :
       {"\\quad\\text{(no sum)}", "\\quad (\\text{no sum over } i)", "\\;(\\text{no sum})",
        ",\\quad\\text{no sum over }i", "\\text{ (no sum on }j\\text{)}", "\\quad\\text{(no sum over $i$)}",
        "\\qquad(\\mathrm{no~sum})"}) {
    INFO(words);
    CHECK(statement(std::string("a_i = b_i") + words) == "a_i = b_i !no-sum");
  }
  CHECK(statement("a = b\\;(\\text{no sum}), \\quad c = d \\quad (6)") ==
        "a = b [(6)] !no-sum // c = d [(6)] !no-sum");
  CHECK(statement("a = b \\quad\\text{no sum, } c = d") == "a = b !no-sum // c = d !no-sum");
}

TEST_CASE("words can say an equation for the other axes, too") {
  for (const char* words :
       {"\\quad\\text{and cyclic permutations}", ",\\text{ etc.}", "\\quad(\\text{and cyc. perm.})",
        "\\quad\\text{and cyclic permutations of }1,2,3",
        "\\;(\\text{and cyclic permutations of }(1,2,3))"}) {
    INFO(words);
    CHECK(statement(std::string("a_1 = b_2") + words) == "a_1 = b_2 !cyclic");
  }
  CHECK(statement("\\text{and cyclically } a = b") == "a = b ?unsupported");
}

TEST_CASE("behind a visible space, the letter on the left side again begins the next equation") {
  const std::string first = "\\dot{\\omega}_1 = \\frac{I_2 - I_3}{I_1} \\omega_2 \\omega_3";
  const std::string second = "\\dot{\\omega}_2 = a";
  for (const char* space : {" \\quad ", "~", "\\ ", " \\qquad "}) {
    INFO(space);
    CHECK(statement(first + space + second) == first + " // " + second);
  }
  CHECK(statement("\\dot\\theta_1 = r\\dot\\theta_2 = a") == "\\dot\\theta_1 = r\\dot\\theta_2 = a");
  CHECK(statement("p_1 = a\\ p_2 = b") == "p_1 = a // p_2 = b");
  CHECK(statement("\\mathbf{p}_1 = a\\enspace\\mathbf p_2' = b") == "\\mathbf{p}_1 = a // \\mathbf p_2' = b");
}

TEST_CASE("behind a visible space, another symbol before a relation has two readings") {
  CHECK(statement("\\dot x = r~\\dot\\theta = a") == "\\dot x = r~\\dot\\theta = a ?ambiguous-reading");
  CHECK(statement("a = b~c = d") == "a = b~c = d ?ambiguous-reading");
  CHECK(statement("a + b = c\\ a < d") == "a + b = c\\ a < d ?ambiguous-reading");
  for (const char* text : {"a = b\\,c = d", "a = b~c", "a = b +~c = d", "a = \\sin~x = d", "a~b = c = d",
                           "a = b~(c) = d", "a = f(b~c) = d"}) {
    INFO(text);
    CHECK(statement(text) == text);
  }
}

TEST_CASE("words that only name an equation or join two change nothing") {
  for (const char* words : {"Newton's law", "and", "definition of the torque"}) {
    INFO(words);
    CHECK(statement(std::string("a = b \\quad\\text{") + words + "}") == "a = b");
  }
}

TEST_CASE("words at the left end, and words that act, belong to the side") {
  for (const char* text :
       {"\\text{grad}(u) = u", "\\text{mass} + a = a", "\\textbf{a} + b = b", "\\text{$a$} + b = b",
        "a = b\\,\\text{sin}(x)", "a = 2\\,\\text{energy}", "a \\text{foo} b = c",
        "\\text{kinetic energy} = T", "\\text{d}x/\\text{d}t = v"}) {
    INFO(text);
    CHECK(statement(text) == text);
  }
  CHECK(statement("\\text{Hence } a = b") == "a = b <=");
  CHECK(statement("\\text{Newton: } a = b") == "a = b");
}

TEST_CASE("a quantifier over everything changes nothing") {
  CHECK(statement("a = b \\quad\\text{for all values}") == "a = b");
  CHECK(statement("a = b \\quad\\forall\\, a, b") == "a = b");
  CHECK(statement("a = b \\quad\\text{for all } a, b") == "a = b");
  CHECK(statement("a = b \\quad\\forall\\, x") == "a = b ~restricted");
}

TEST_CASE("signs beside an equation that are not understood leave it unjudged") {
  CHECK(statement("a = b \\quad x") == "a = b ?unsupported");
  CHECK(statement("a = b \\quad (x \\text{ constant})") == "a = b ~restricted");
}

TEST_CASE("what stands behind an arrow is concluded") {
  for (const char* arrow :
       {"\\Rightarrow", "\\implies", "\\therefore", "\\quad\\text{hence}\\quad", "\\quad\\to\\quad"}) {
    INFO(arrow);
    CHECK(statement(std::string("a = b ") + arrow + " c = d") == "a = b // c = d <=");
  }
  CHECK(statement("a = b \\iff c = d") == "a = b // c = d <=>");
  CHECK(statement("\\therefore a = b") == "a = b <=");
}

TEST_CASE("what stands behind a word of explanation says what a letter is") {
  CHECK(statement("a = bc, \\quad\\text{where } c = d") == "a = bc // c = d :explains");
}

TEST_CASE("full stops and commas at the end are no part of a side") {
  CHECK(statement("a = b.") == "a = b");
  CHECK(statement("a = b\\,,") == "a = b");
  CHECK(statement("a = b = c ;") == "a = b = c");
}

TEST_CASE("words where an operand is due are the operand") {
  CHECK(statement("m = \\text{const}") == "m = \\text{const}");
  CHECK(statement("m = \\text{const}\\quad c = d") == "m = \\text{const} // c = d");
}

TEST_CASE("what is written over a relation can change it") {
  CHECK(first_relation("a \\overset{!}{=} b") == RelationKind::demanded);
  CHECK(first_relation("a \\stackrel{\\text{def}}{=} b") == RelationKind::defines);
  CHECK(first_relation("a \\overset{(6)}{=} b") == RelationKind::equal);
  CHECK(first_relation("a \\stackrel{x}{\\approx} b") == RelationKind::other);
  CHECK(first_relation("a := b") == RelationKind::defines);
  CHECK(first_relation("a \\not= b") == RelationKind::unequal);
  CHECK(first_relation("a \\not\\approx b") == RelationKind::other);
  CHECK(first_relation("a \\overset{(6)}{\\le} b") == RelationKind::less_or_equal);
}

TEST_CASE("arrows over a letter are no relation") {
  CHECK(statement("\\overset{\\leftrightarrow}{I} = a") == "\\overset{\\leftrightarrow}{I} = a");
  CHECK_FALSE(
      ask([](TokenView tokens) { return is_stacked_relation(tokens, 0); }, "\\overset{\\leftrightarrow}{I}"));
  CHECK(ask([](TokenView tokens) { return is_stacked_relation(tokens, 0); }, "\\overset{!}{=}"));
}

TEST_CASE("a relation counts outside brackets and scripts only") {
  CHECK(ask(has_relation, "a = b"));
  CHECK(ask(has_relation, "a \\stackrel{!}{=} b"));
  CHECK_FALSE(ask(has_relation, "f(a = b)"));
  CHECK_FALSE(ask(has_relation, "A_\\perp"));
  CHECK_FALSE(ask(has_relation, "\\sum_{i=1}^3 a"));
  CHECK_FALSE(ask(has_relation, "\\Rightarrow"));
}

TEST_CASE("only bare index letters are a condition on the indices") {
  CHECK(ask(relates_index_letters, "(i \\ne j)"));
  CHECK(ask(relates_index_letters, "i = j = k"));
  CHECK(ask(relates_index_letters, "i = 1"));
  CHECK_FALSE(ask(relates_index_letters, "x = y"));
  CHECK_FALSE(ask(relates_index_letters, "i, j"));
}

TEST_CASE("a text ends open behind a relation or an operator") {
  CHECK(ask(ends_open, "a ="));
  CHECK(ask(ends_open, "a \\times \\quad"));
  CHECK(ask(ends_open, "a +\\,"));
  CHECK_FALSE(ask(ends_open, "a"));
  CHECK_FALSE(ask(ends_open, "n_+"));
  CHECK_FALSE(ask(ends_open, ""));
}

TEST_CASE("blanks and spacing are not significant, a wide space is") {
  const Stretch stretch(" \\, \\quad a");
  CHECK(is_control(stretch.tokens.at(first_significant(stretch.tokens, 0)), "quad"));
}
