// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers with units.
#include "catch.h"
#include "latex/dump_syntax.h"

namespace {

using namespace rigor;

std::string parsed(const std::string& text) {
  Stretch stretch(text);
  SyntaxTree tree;
  const Tokens side = stretch.side();
  return dump_syntax(tree, parse_side(side, span_of(side), tree));
}

std::string chains(const std::string& text) {
  Stretch stretch(text);
  return dump_chains(split_display(stretch.tokens, "", stretch.diagnostics));
}

}  // namespace

TEST_CASE("siunitx writes a number, a unit, or both") {
  for (const char* text :
       {"\\SI{3}{kg.m^2}", "\\qty{3}{kg.m^2}", "\\SI[mode=text]{3}{kg.m^2}", "\\qty {3} {kg.m^2}"}) {
    INFO(text);
    CHECK(parsed(text) == parsed("\\SI{3}{kg.m^2}"));
    CHECK(parsed(text).find("3") != std::string::npos);
    CHECK(parsed(text).find("<kg.m^2>") != std::string::npos);
  }
  CHECK(parsed("\\unit{m/s}") == "<m/s>");
  CHECK(parsed("\\si{\\metre\\per\\second}") == "<\\metre\\per\\second>");
}

TEST_CASE("an angle in degrees is a multiple of pi, and a unit may have no number") {
  CHECK(parsed("\\ang{30}") == parsed("(30\\frac{\\pi}{180})"));
  CHECK(parsed("\\ang{30;15;}") == parsed("\\num{30;15;}"));
  CHECK(parsed("\\SI{}{kg}") == parsed("\\si{kg}"));
}

TEST_CASE("a number of siunitx may have a sign and a power of ten") {
  CHECK(parsed("\\num{3.2e5}") == "320000");
  CHECK(parsed("\\num{3.25e1}") == "32.5");
  CHECK(parsed("\\num{+1.5E-3}") == "0.0015");
  CHECK(parsed("\\num{12e-2}") == "0.12");
  CHECK(parsed("\\num{.5}") == "0.5");
  CHECK(parsed("\\num{-3}").find("-3") != std::string::npos);
  for (const char* text :
       {"\\num{}", "\\num{3(1)}", "\\num{1e999}", "\\num{1e}", "\\num{a}", "\\num{1.2.3}"}) {
    INFO(text);
    CHECK(parsed(text) == "<unsupported>");
  }
}

TEST_CASE("qty is a bracket, unless a number and a unit stand in two braces") {
  CHECK(parsed("\\qty(a + b)") == parsed("(a + b)"));
  CHECK(parsed("\\qty{a + b}") == parsed("(a + b)"));
  CHECK(parsed("\\qty{a}{kg}").find("<kg>") == std::string::npos);
  CHECK(parsed("\\qty{3}{xyz}").find("<xyz>") == std::string::npos);
}

TEST_CASE("a roman word behind a number is a unit") {
  for (const char* text : {"3\\,\\mathrm{kg}", "3\\mathrm{kg}", "3~\\mathrm{kg}", "3\\,\\text{kg}",
                           "3\\text{ kg}", "3\\ \\textrm{kg}"}) {
    INFO(text);
    CHECK(parsed(text) == "(term 3 <kg>)");
  }
  CHECK(parsed("10^8\\,\\mathrm{m}") == "(term (power 10 8) <m>)");
  CHECK(parsed("3\\,\\mathrm{kg}\\,\\mathrm{m}^2") == "(term 3 <kg> (power <m> 2))");
}

TEST_CASE("letters, labels, functions and differentials in roman type are no units") {
  for (const char* text :
       {"2\\mathrm{V}", "2\\,\\mathrm{d}x", "2\\mathrm{d}", "a\\,\\mathrm{m}", "2\\,\\mathrm{T}_1",
        "2\\,\\mathrm{T}'", "T_{\\mathrm{kg}}", "2\\,\\mathrm{sin}\\,x", "2\\,\\mathrm{min}(a)"}) {
    INFO(text);
    CHECK(parsed(text).find('<' + std::string("unsupported")) == parsed(text).find('<'));
  }
}

TEST_CASE("a unit in words is no remark beside the equation") {
  CHECK(chains("m = 3\\text{ kg}") == "m = 3\\text{ kg}");
  CHECK(chains("m = 3 \\text{ and } a + b = b + a") == "m = 3 // a + b = b + a");
}
