// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/split/conditions.h"

#include "catch.h"
#include "latex/dump_syntax.h"

namespace {

using namespace rigor;

std::string joined(const std::optional<std::vector<Tokens>>& conditions) {
  if (!conditions) return "none";
  std::string text;
  for (const Tokens& condition : *conditions) text += (text.empty() ? "" : " // ") + text_of(condition);
  return text;
}

std::string in(const std::string& text) {
  const Stretch stretch(text);
  return joined(conditions_in(stretch.tokens));
}

std::string behind_words(const std::string& text) {
  const Stretch stretch(text);
  return joined(conditions_behind_words(stretch.tokens));
}

std::string in_tag(const std::string& text) {
  const Stretch stretch(text);
  return joined(conditions_in_tag(stretch.tokens));
}

std::string at_braces(const std::string& text) {
  const Stretch stretch(text);
  return joined(said_at_braces(stretch.tokens));
}

}  // namespace

TEST_CASE("relations with commas between are conditions, and letters before one share it", "[conditions]") {
  CHECK(in("x>0") == "x>0");
  CHECK(in("(x>0)") == "x>0");
  CHECK(in("x,y>0") == "x>0 // y>0");
  CHECK(in("x>0,y\\ne1") == "x>0 // y\\ne1");
  CHECK(in("x") == "none");
  CHECK(in("x\\ll1") == "none");
  CHECK(in("x\\in A") == "none");
  CHECK(in("n=1,2,3") == "none");
  CHECK(in("i\\ne j") == "none");
  CHECK(in("x>0,y") == "none");
}

TEST_CASE("a closed list of words brings conditions in", "[conditions]") {
  CHECK(behind_words("\\text{if }x=0") == "x=0");
  CHECK(behind_words("\\text{for $x>0$}") == "x>0");
  CHECK(behind_words("\\text{provided that }x>0\\text{ and }y>0") == "x>0 // y>0");
  CHECK(behind_words("\\text{where }x>0") == "x>0");
  CHECK(behind_words("\\text{where }x=y") == "none");
  CHECK(behind_words("\\text{unless }x=0") == "none");
  CHECK(behind_words("\\text{for large }x>0") == "none");
  CHECK(behind_words("\\text{if }x>0\\text{ or }y>0") == "none");
  CHECK(behind_words("x>0") == "none");
}

TEST_CASE("a tag may hold a condition behind its number", "[conditions]") {
  CHECK(in_tag("for $x>0$") == "x>0");
  CHECK(in_tag("3, $x>0$") == "x>0");
  CHECK(in_tag("if $x=0$") == "x=0");
  CHECK(in_tag("$x=0$") == "none");
  CHECK(in_tag("unless $x>0$") == "none");
  CHECK(in_tag("3") == "none");
}

TEST_CASE("zero or a relation at a brace says something of its part", "[conditions]") {
  CHECK(at_braces("\\underbrace{a+b}_{0}+c") == "a+b=0");
  CHECK(at_braces("\\frac{\\overbrace{a-b}^{\\ne0}}{c}") == "a-b\\ne0");
  CHECK(at_braces("\\underbrace{a}_{=b}\\underbrace{c}_{>0}") == "a=b // c>0");
  CHECK(at_braces("\\underbrace{\\mathbf a}_{\\mathbf 0}").starts_with("\\mathbf a=\\mathbf"));
  CHECK(at_braces("\\underbrace{a}_{1}\\underbrace{b}_{T}\\underbrace{c}_{\\ll 1}").empty());
}
