// SPDX-License-Identifier: GPL-3.0-or-later
#include "catch.h"
#include "latex/dump_syntax.h"
#include "latex/split/acting.h"

namespace {

using namespace rigor;

std::string parsed(const std::string& text) {
  Stretch stretch(text);
  SyntaxTree tree;
  const Tokens tokens = stretch.side();
  return dump_syntax(tree, parse_side(tokens, {}, tree));
}

}  // namespace

TEST_CASE("operators written as words act on a bracket or on the one factor behind them") {
  for (const char* word :
       {"\\operatorname{grad}", "\\mathrm{grad}", "\\text{grad}", "\\mathop{\\rm grad}\\nolimits",
        "\\textrm{grad }", "{\\rm grad}", "\\mathop{\\mathrm{grad}}"}) {
    INFO(word);
    CHECK(parsed(std::string(word) + "\\,f") == "(grad f)");
    CHECK(parsed(std::string(word) + "(f + g)") == "(grad (sum +f +g))");
  }
  CHECK(parsed("\\operatorname{rot}\\operatorname{rot}\\mathbf A") == "(curl (curl vector:A))");
  CHECK(parsed("\\operatorname{div}(f\\mathbf A) + 1") == "(sum +(div (term f vector:A)) +1)");
  CHECK(parsed("\\text{det}(A)") == "(det A)");
  CHECK(parsed("\\text{sin}(x)") == "(sin x)");
}

TEST_CASE("how far an operator written as a word acts is not guessed") {
  for (const char* text :
       {"\\text{grad} f g", "\\text{div} f\\mathbf A", "\\text{rot}\\mathbf A\\times\\mathbf B",
        "\\text{grad} f^2", "\\text{grad}(f)^2"}) {
    INFO(text);
    CHECK(parsed(text).find("<ambiguous-reading>") != std::string::npos);
  }
  CHECK(parsed("\\text{div} A") == "<unsupported>");
  CHECK(parsed("\\text{grad} + a") == "(sum +<unsupported> +a)");
}

TEST_CASE("other words are no quantities") {
  for (const char* text :
       {"\\text{Ma } z", "\\operatorname{sgn} x", "\\mathrm{Prob}(x)", "\\text{foo} x", "{\\rm Ma} z"}) {
    INFO(text);
    CHECK(parsed(text).starts_with("(term <"));
  }
}

TEST_CASE("letters in text are letters, in their face") {
  CHECK(parsed("\\textbf{a}\\times\\textbf{b}") == "(term vector:a ×vector:b)");
  CHECK(parsed("\\textit{a} + \\emph{b}") == "(sum +a +b)");
  CHECK(parsed("\\text{$a + b$} c") == "(term (sum +a +b) c)");
  CHECK(parsed("\\text{a}") == "\\mathrm{a}");
}

TEST_CASE("a Landau symbol of a power of a letter is no product") {
  for (const char* text : {"O(a^2)", "\\mathcal O(a^2)", "\\mathcal{O}\\left(a^2\\right)", "\\order{a^2}",
                           "O\\!\\left(a^2\\right)", "\\mathrm{O}(a^2)", "{\\cal O}(a^2)"}) {
    INFO(text);
    CHECK(parsed(text) == "(O (power a 2))");
  }
  CHECK(parsed("a + O(b)") == "(sum +a +(O b))");
}

TEST_CASE("a small o, the order of more than a letter, and a group's name are not read") {
  for (const char* text : {"o(x)", "O(ab)", "O(a^n)", "O(a + b)", "O(1)", "O()"}) {
    INFO(text);
    CHECK(parsed(text) == "<unsupported>");
  }
  CHECK(parsed("O_1(a)") == "(term O[1] (group a))");
  CHECK(parsed("2O") == "(term 2 O)");
}

TEST_CASE("the derivative along a motion is no quotient") {
  for (const char* text : {"\\frac{Df}{Dt}", "\\frac{\\mathrm D f}{\\mathrm D t}", "Df/Dt"}) {
    INFO(text);
    CHECK(parsed(text) == "(D/Dt f)");
  }
  CHECK(parsed("\\frac{D\\mathbf v}{Dt}") == "(D/Dt vector:v)");
  CHECK(parsed("\\frac{D(fg)}{Dt}") == "(D/Dt (group (term f g)))");
  CHECK(parsed("\\frac{D}{Dt}(f + g)") == "(D/Dt (group (sum +f +g)))");
  CHECK(parsed("a \\frac{Df}{Dt}") == "(term a (D/Dt f))");
  for (const char* text : {"\\frac{\\mathrm{D}^2 x}{\\mathrm{D}t^2}", "\\frac{D V}{D\\tau}",
                           "\\frac{D fg}{Dt}", "\\frac{D}{Dt} fg", "\\frac{D}{Dt}"}) {
    INFO(text);
    CHECK(parsed(text).starts_with("<"));
  }
  CHECK(parsed("\\frac{D}{D_0}") == "(fraction D D[0])");
  CHECK(parsed("\\frac{Da}{b}") == "(fraction (term D a) b)");
  CHECK(parsed("\\frac{D + a}{Dt}") == "(fraction (sum +D +a) (term D t))");
}

TEST_CASE("a differential by itself is no factor") {
  CHECK(parsed("T\\,\\mathrm dS") == "(term T (d/ S))");
  CHECK(parsed("\\mathrm{d}(xy)") == "(d/ (group (term x y)))");
  for (const char* text : {"\\mathrm dx^2", "\\mathrm{d}^2x"}) {
    INFO(text);
    CHECK(parsed(text).find("<unsupported>") != std::string::npos);
  }
  CHECK(parsed("\\frac{\\mathrm dx}{\\mathrm dt}") == "(d/dt x)");
}
