// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/split/split.h"

#include "catch.h"
#include "latex/dump_syntax.h"

namespace {

using namespace rigor;

std::string split(const std::string& environment, const std::string& text) {
  Stretch stretch(text);
  return dump_chains(split_display(stretch.tokens, environment, stretch.diagnostics));
}

std::string split(const std::string& text) { return split("", text); }

}  // namespace

TEST_CASE("a chain is cut at each relation") {
  CHECK(split("a = b = c") == "a = b = c");
  CHECK(split("a \\equiv b \\approx c < d") == "a \\equiv b \\approx c < d");
  CHECK(split("a := b") == "a := b");
}

TEST_CASE("a relation in brackets or in a script cuts nothing") {
  CHECK(split("f(a=b) = c") == "f(a=b) = c");
  CHECK(split("\\sum_{i=1}^3 a_i = b") == "\\sum_{i=1}^3 a_i = b");
  Stretch stretch("A_\\perp = 0");
  CHECK(split_display(stretch.tokens, "", stretch.diagnostics).at(0).sides.size() == 2);
}

TEST_CASE("a row that begins with a relation goes on with the chain above it") {
  CHECK(split("align", "a &= b \\\\ &= c \\\\ &= d") == "a = b = c = d");
  CHECK(split("align", "a &= b \\\\ &= c \\\\ d &= e") == "a = b = c // d = e");
  CHECK(split("gather", "a = b \\\\ = c") == "a = b = c");
  CHECK(split("a =& b \\\\ =& c") == "a = b = c");
  CHECK(split("\\begin{split}a &= b \\\\ &= c\\end{split}") == "a = b = c");
  CHECK(split("\\begin{aligned}a &= b \\\\ &\\stackrel{x}{=} c\\end{aligned}") == "a = b \\stackrel{x}{=} c");
}

TEST_CASE("a row that begins with a sign behind an empty cell goes on with the side above it") {
  CHECK(split("align", "a &= b \\\\ &\\quad + c") == "a = b + c");
  CHECK(split("align", "a &= b \\\\ &\\times c") == "a = b \\times c");
  CHECK(split("align", "a &= b \\\\ &- c \\\\ &= d") == "a = b - c = d");
}

TEST_CASE("a row goes on where the one above ends in a sign or an open bracket") {
  CHECK(split("align", "a &= b + \\\\ & c") == "a = b + c");
  CHECK(split("align", "a &= b \\cdot \\\\ & c") == "a = b \\cdot c");
  CHECK(split("align", "a = \\\\ b") == "a = b");
  CHECK(split("align", "a &= (b \\\\ &\\quad c)") == "a = (b c)");
  CHECK(split("align", "a &= \\left[b \\right. \\\\ &\\left. c\\right]") == "a = [b c]");
}

TEST_CASE("all rows of multline are one chain") {
  CHECK(split("multline", "a = b \\\\ + c \\\\ = d") == "a = b + c = d");
  CHECK(split("multline*", "a = b \\\\ c") == "a = b c");
}

TEST_CASE("each row of gather is a chain") {
  CHECK(split("gather", "a = b \\\\ c = d") == "a = b // c = d");
  CHECK(split("\\begin{gathered}a = b \\\\ c = d\\end{gathered}") == "a = b // c = d");
}

TEST_CASE("eqnarray sets the relation in a column of its own") {
  CHECK(split("eqnarray", "a &=& b \\\\ &=& c \\\\ d &=& e") == "a = b = c // d = e");
  CHECK(split("eqnarray*", "a &=& b \\\\ && + c") == "a = b + c");
  CHECK(split("align", "a &=& b \\\\ &=& c") == "a = b = c");
}

TEST_CASE("columns of equations are read downwards") {
  CHECK(split("align", "a &= b & c &= d \\\\ &= e & &= f") == "a = b = e // c = d = f");
  CHECK(split("align*", "a &= b, & c &= d") == "a = b // c = d");
}

TEST_CASE("words in a column of their own belong to the equation beside them") {
  CHECK(split("align", "a &= b && \\text{(law)} \\\\ c &= d") == "a = b // c = d");
  CHECK(split("align", "a &= b && \\text{no sum} \\\\ c &= d") == "a = b !no-sum // c = d");
  CHECK(split("align", "a &= b && \\text{if so} \\\\ c &= d") == "a = b ~restricted // c = d");
  CHECK(split("align", "a_i &= b_i && i \\ne j \\\\ c &= d") == "a_i = b_i ~restricted // c = d");
}

TEST_CASE("a system in cases is one chain a row") {
  CHECK(split("\\begin{cases}a = b \\\\ c = d\\end{cases} \\tag{3}") == "a = b [(3)] // c = d [(3)]");
  CHECK(split("\\begin{cases}a &= b \\\\ c &= d\\end{cases}") == "a = b // c = d");
}

TEST_CASE("a definition by cases is one side") {
  const std::string cases = "\\begin{cases}1 & i = j\\\\ 0 & \\text{otherwise}\\end{cases}";
  CHECK(split("T_{ij} = " + cases) == "T_{ij} = " + cases);
}

TEST_CASE("a row that can go on or stand for itself leaves the one above unjudged") {
  CHECK(split("gather", "a = b \\\\ c") == "a = b ?ambiguous-reading // c");
  CHECK(split("gather", "a = b \\\\ -c = d") == "a = b ?ambiguous-reading // -c = d ~restricted");
  CHECK(split("gather", "a = b, \\\\ -c = d") == "a = b ?ambiguous-reading // -c = d");
  CHECK(split("align", "a &= b \\\\ +c &= d") == "a = b ?ambiguous-reading // +c = d ~restricted");
  CHECK(split("gather", "a = b \\\\ c = d") == "a = b // c = d");
}

TEST_CASE("a row that begins with a plus or the sign of a product goes on with the side above it") {
  CHECK(split("gather", "a = b \\\\ +c = d") == "a = b +c = d");
  CHECK(split("a = b \\\\ \\times c = d") == "a = b \\times c = d");
  CHECK(split("gather", "a = b. \\\\ +c = d") == "a = b ?ambiguous-reading // +c = d");
}

TEST_CASE("three dots are no full stop") {
  CHECK(split("a = b = ...") == "a = b = ...");
  CHECK(split("a = b = ....") == "a = b = ...");
  CHECK(split("a = b...,") == "a = b...");
  CHECK(split("a = 0.33...") == "a = 0.33");
  CHECK(split("a = 0.33\\ldots\\,.") == "a = 0.33");
  CHECK(split("a = 3...") == "a = 3...");
}

TEST_CASE("a chain does not run across words between the rows") {
  CHECK(split("align", "a &= b \\\\ \\intertext{so} c &= d") == "a = b // c = d");
  CHECK(split("align", "a &= b \\\\ c &= d \\\\ &= e") == "a = b // c = d = e");
}

TEST_CASE("each row keeps its tag and label, a single one names the whole display") {
  CHECK(split("align", "a &= b \\tag{1} \\\\ c &= d \\tag{2}") == "a = b [(1)] // c = d [(2)]");
  CHECK(split("align", "a &= b \\label{x} \\\\ c &= d \\label{y}") == "a = b [x] // c = d [y]");
  CHECK(split("align", "a &= b \\\\ c &= d \\tag{7}") == "a = b [(7)] // c = d [(7)]");
}

TEST_CASE("line numbers that are switched off change nothing") {
  CHECK(split("align", "a &= b \\nonumber \\\\ &= c \\notag") == "a = b = c");
}

TEST_CASE("the spans of a chain are where its parts were written") {
  Stretch stretch("a &= b + c \\\\ &= d");
  const std::vector<WrittenChain> chains = split_display(stretch.tokens, "align", stretch.diagnostics);
  REQUIRE(chains.size() == 1);
  REQUIRE(chains[0].sides.size() == 3);
  CHECK(stretch.written(chains[0].sides[1].span) == "b + c");
  CHECK(stretch.written(chains[0].relations[1].span) == "=");
  CHECK(stretch.written(chains[0].span) == "a &= b + c \\\\ &= d");
}

TEST_CASE("a side that is missing is empty at the relation") {
  Stretch stretch("a =");
  const std::vector<WrittenChain> chains = split_display(stretch.tokens, "", stretch.diagnostics);
  REQUIRE(chains.size() == 1);
  REQUIRE(chains[0].sides.size() == 2);
  CHECK(chains[0].sides[1].tokens.empty());
  CHECK(chains[0].sides[1].span.begin == 3);
}

TEST_CASE("an expression alone is a chain without a relation") {
  Stretch stretch("a + b");
  const std::vector<WrittenChain> chains = split_display(stretch.tokens, "", stretch.diagnostics);
  REQUIRE(chains.size() == 1);
  CHECK(chains[0].relations.empty());
}
