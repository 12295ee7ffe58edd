// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/token/tokens.h"

#include "catch.h"
#include "latex/dump_syntax.h"

namespace {

using namespace rigor;

/// The argument at the first token, and what is left behind it: `a|b`.
std::string argument(const std::string& text) {
  const Stretch stretch(text);
  const TokenView tokens = stretch.tokens;
  const Argument found = argument_at(tokens, 0);
  return text_of(found.content) + "|" + text_of(tokens.subspan(found.next));
}

std::string optional_argument(const std::string& text) {
  const Stretch stretch(text);
  const TokenView tokens = stretch.tokens;
  const Argument found = optional_argument_at(tokens, 0);
  return text_of(found.content) + "|" + text_of(tokens.subspan(found.next));
}

/// The depth of each token, as digits.
std::string depths(const std::string& text, bool braces_only) {
  const Stretch stretch(text);
  Nesting nesting(braces_only);
  std::string digits;
  for (const Token& token : stretch.tokens) digits += static_cast<char>('0' + nesting.enter(token));
  return digits;
}

std::string text_again(const std::string& text) { return text_of(Stretch(text).tokens); }

}  // namespace

TEST_CASE("a control, a sign and a letter of one text are told apart") {
  const Stretch stretch("\\times*t");
  CHECK(is_control(stretch.tokens[0], "times"));
  CHECK_FALSE(is_control(stretch.tokens[0], "time"));
  CHECK_FALSE(is_sign(stretch.tokens[0], "times"));
  CHECK(is_sign(stretch.tokens[1], "*"));
  CHECK_FALSE(is_control(stretch.tokens[1], "*"));
  CHECK_FALSE(is_sign(stretch.tokens[2], "t"));
}

TEST_CASE("spaces and paragraphs are blank, a spacing control is not") {
  const Stretch stretch("a b\n\nc\\,");
  CHECK(is_blank(stretch.tokens[1]));
  CHECK(is_blank(stretch.tokens[3]));
  CHECK_FALSE(is_blank(stretch.tokens[5]));
  CHECK(skip_blank(stretch.tokens, 1) == 2);
  CHECK(skip_blank(stretch.tokens, 2) == 2);
  CHECK(skip_blank(stretch.tokens, 6) == 6);
}

TEST_CASE("an argument is a brace group or one token") {
  CHECK(argument("{ab}c") == "ab|c");
  CHECK(argument("  {ab}c") == "ab|c");
  CHECK(argument("abc") == "a|bc");
  CHECK(argument("\\alpha b") == "\\alpha|b");
  CHECK(argument("{a{b}c}d") == "a{b}c|d");
  CHECK(argument("{}a") == "|a");
}

TEST_CASE("a parameter is written with its mark") { CHECK(text_again("a#b#1") == "a#b#1"); }

TEST_CASE("an argument that is missing or not closed ends with the text") {
  CHECK(argument("") == "|");
  CHECK(argument("  ") == "|");
  CHECK(argument("{ab") == "ab|");
}

TEST_CASE("an optional argument stands in square brackets, or is not there") {
  CHECK(optional_argument("[2pt] a") == "2pt|a");
  CHECK(optional_argument(" [a]b") == "a|b");
  CHECK(optional_argument("[{]}]b") == "{]}|b");
  CHECK(optional_argument("ab") == "|ab");
  CHECK(optional_argument("[ab") == "|[ab");
}

TEST_CASE("a token behind a script mark is its argument") {
  const Stretch stretch("A_\\perp=B^ =");
  CHECK_FALSE(is_script_argument(stretch.tokens, 0));
  CHECK(is_script_argument(stretch.tokens, 2));
  CHECK_FALSE(is_script_argument(stretch.tokens, 3));
  CHECK(is_script_argument(stretch.tokens, 7));
}

TEST_CASE("an opening and its closing token lie outside what they enclose") {
  CHECK(depths("a{b}c", true) == "00100");
  CHECK(depths("a(b[c])d", false) == "00112100");
  CHECK(depths("a(b)c", true) == "00000");
  CHECK(depths("\\{a\\}", false) == "010");
  CHECK(depths("\\lvert a\\rvert b", false) == "0100");
}

TEST_CASE("what lies between begin and end is one deeper") {
  CHECK(depths("\\begin{x}a\\end{x}b", true) == "0121100100");
}

TEST_CASE("a closing bracket without an opening one does not go below the outside") {
  CHECK(depths("a)}b(c", false) == "000001");
}

TEST_CASE("the text of tokens has its controls and single spaces again") {
  CHECK(text_again("  a +\n b ") == "a + b");
  CHECK(text_again("\\mathbf  A") == "\\mathbf A");
  CHECK(text_again("\\alpha2") == "\\alpha2");
  CHECK(text_again("\\, a") == "\\, a");
  CHECK(text_again("") == "");
}

TEST_CASE("the span of tokens covers the first to the last") {
  const Stretch stretch("a + bc");
  CHECK(stretch.written(span_of(stretch.tokens)) == "a + bc");
  CHECK(stretch.written(span_of(TokenView(stretch.tokens).subspan(2, 3))) == "+ b");
  CHECK(span_of({}).empty());
}

TEST_CASE("trimming takes blanks from both ends and leaves those inside") {
  const Stretch stretch(" a b ");
  CHECK(trim(stretch.tokens).size() == 3);
  const Stretch blank("  ");
  CHECK(trim(blank.tokens).empty());
}
