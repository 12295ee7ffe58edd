// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/token/accounting.h"

#include "catch.h"
#include "latex/dump_syntax.h"

namespace {

using namespace rigor;

/// One letter for each token: what it is to its display. s side, r relation, n name, l layout, a aside,
/// m remark, c condition, - nothing.
std::string uses(const std::string& text) {
  Stretch stretch(text);
  const SplitDisplay split = split_and_count(stretch.tokens, "", stretch.diagnostics);
  std::string letters;
  for (const Token& token : split.tokens) {
    if (!is_blank(token)) letters += "-srnlamc"[static_cast<int>(split.uses.of(token))];
  }
  return letters;
}

std::string side(const std::string& text) {
  Stretch stretch(text);
  SyntaxTree tree;
  const Tokens tokens = stretch.side();
  return dump_syntax(tree, parse_side(tokens, {}, tree));
}

}  // namespace

TEST_CASE("each token of a display is something to its chains") {
  CHECK(uses("a+b = c.") == "sssrsl");
  CHECK(uses("a = b \\tag{1}") == "srsnnnn");
  CHECK(uses("a_i = b_i \\quad i = 1, 2, 3") == "sssrsss-mmmmmmm");
  CHECK(uses("\\left( a \\right) = b") == "lsslsrs");
  CHECK(uses("a = b, c = d") == "srslsrs");
}

TEST_CASE("words are a remark, a condition or part of a side") {
  CHECK(uses("a = b \\quad\\text{or}") == "srs-mmmmm");
  CHECK(uses("a = b \\quad\\text{if}") == "srs-ccccc");
  CHECK(uses("\\text{Ma} = b") == "sssssrs");
}

TEST_CASE("signs that set only the space need no use") {
  SideAccount account{{}};
  CHECK(account.left_over() == nullptr);
  const Stretch stretch("{\\,a}");
  SideAccount side(stretch.tokens);
  REQUIRE(side.left_over() != nullptr);
  CHECK(side.left_over()->text == "a");
  side.read(TokenView(stretch.tokens).subspan(2, 1));
  CHECK(side.left_over() == nullptr);
}

TEST_CASE("a second script on one base is a slip, unless a group stands between") {
  CHECK(side("a_{i}_{j}") == "<bad-syntax>");
  CHECK(side("a^2^3") == "<bad-syntax>");
  CHECK(side("T_i{}_j") == "T[i,j]");
  CHECK(side("\\sum_{}_{ij} b") == "<bad-syntax>");
}
