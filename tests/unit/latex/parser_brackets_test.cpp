// SPDX-License-Identifier: GPL-3.0-or-later
// Brackets, bars, annotations and environments inside an expression.
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

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int k = 0; k < count; ++k) all += text;
  return all;
}

}  // namespace

TEST_CASE("visible brackets are a group, braces are none") {
  CHECK(parsed("(a+b)c") == "(term (group (sum +a +b)) c)");
  CHECK(parsed("[2a]\\{2b\\}") == "(term (group (term 2 a)) (group (term 2 b)))");
  CHECK(parsed("{a+b}c") == "(term (sum +a +b) c)");
  CHECK(parsed("\\left(a\\right)\\bigl[2b\\bigr]") == "(term (group a) (group (term 2 b)))");
  CHECK(parsed("\\qty(a+b)c") == "(term (group (sum +a +b)) c)");
}

TEST_CASE("an index on a bracket is a component") {
  CHECK(parsed("(\\mathbf A\\times\\mathbf B)_i") == "(component[i] (group (term vector:A ×vector:B)))");
  CHECK(parsed("(\\mathbf A\\mathbf B)_{ij}") == "(component[i,j] (group (term vector:A vector:B)))");
}

TEST_CASE("commas in brackets make a tuple") {
  CHECK(parsed("(a,b+c,d)") == "(tuple a (sum +b +c) d)");
  CHECK(parsed("(a,(b,c))") == "(tuple a (tuple b c))");
}

TEST_CASE("every way to write a bar is read") {
  for (const char* text :
       {"|A|", "\\left|A\\right|", "\\lvert A\\rvert", "\\vert A\\vert", "\\abs{A}", "\\bigl|A\\bigr|"}) {
    INFO(text);
    CHECK(parsed(text) == "(bars A)");
  }
  for (const char* text :
       {"\\|A\\|", "\\left\\|A\\right\\|", "\\lVert A\\rVert", "\\Vert A\\Vert", "\\norm{A}"}) {
    INFO(text);
    CHECK(parsed(text) == "(norm A)");
  }
}

TEST_CASE("a bar behind an operand closes, any other opens") {
  CHECK(parsed("|A||B|") == "(term (bars A) (bars B))");
  CHECK(parsed("|A|B|C|") == "(term (bars A) B (bars C))");
  CHECK(parsed("|A|\\,|B|^2") == "(term (bars A) (power (bars B) 2))");
  CHECK(parsed("|\\mathbf{A}_i|") == "(bars vector:A[i])");
  CHECK(parsed("|A'||B_{\\perp}|") == "(term (bars A') (bars B[\"\\perp\"]))");
}

TEST_CASE("bars nest behind a sign and inside sized bars") {
  CHECK(parsed("||A|-|B||") == "(bars (sum +(bars A) -(bars B)))");
  CHECK(parsed("|A\\times|B|C|") == "(bars (term A ×(bars B) C))");
  CHECK(parsed("\\left| |A||B| \\right|") == "(bars (term (bars A) (bars B)))");
  CHECK(parsed("\\left|A\\left|B\\right|\\right|") == "(bars (term A (bars B)))");
  CHECK(parsed("|(|A|+B)C|") == "(bars (term (group (sum +(bars A) +B)) C))");
}

TEST_CASE("a bracket or bar without its partner is unbalanced") {
  CHECK(parsed("(a") == "<unbalanced>");
  CHECK(parsed("a + (b") == "(sum +a +<unbalanced>)");
  CHECK(parsed("a)b") == "(term a <unbalanced> b)");
  CHECK(parsed("|a") == "<unbalanced>");
  CHECK(parsed("\\left|a\\right.") == "<unbalanced>");
}

TEST_CASE("what is written under a brace does not change an expression, a sign over it may") {
  CHECK(parsed("\\underbrace{a+b}_{c} d") == "(term (group (sum +a +b) \"c\") d)");
  CHECK(parsed("\\underbrace{a+b}_{\\text{total mass}}") == "(group (sum +a +b) \"\\text{total mass}\")");
  for (const char* label : {"0", "=0", ">0", "\\mathbf 0"}) {
    INFO(label);
    CHECK(parsed(std::string("\\underbrace{a+b}_{") + label + "} d")
              .starts_with("(term (group (sum +a +b) \""));
  }
  for (const char* label : {"1", "\\to 0", "\\approx 0", "\\ll c"}) {
    INFO(label);
    CHECK(parsed(std::string("\\underbrace{a+b}_{") + label + "} d") == "(term <passed-over> d)");
  }
  CHECK(parsed("\\underbrace{a+b}_{\\text{small}} d") == "(term (group (sum +a +b) <restricted>) d)");
  CHECK(parsed("\\overbrace{a}^{\\text{work}}") == "(group a \"\\text{work}\")");
  CHECK(parsed("\\overset{x}{a}") == "<unsupported>");
  CHECK(parsed("\\boxed{a+b}") == "(sum +a +b)");
}

TEST_CASE("one row or one column is a tuple, a rectangle a matrix") {
  CHECK(parsed("\\begin{pmatrix}a\\\\b\\\\c\\end{pmatrix}") == "(tuple a b c)");
  CHECK(parsed("\\begin{bmatrix}a&b&c\\end{bmatrix}") == "(tuple a b c)");
  CHECK(parsed("\\begin{pmatrix}a&b\\\\c&d\\\\\\end{pmatrix}") == "(matrix a b c d)");
  CHECK(parsed("\\left(\\begin{array}{cc}a&b\\\\c&d\\end{array}\\right)") == "(group (matrix a b c d))");
  CHECK(parsed("\\begin{vmatrix}a&b\\\\c&d\\end{vmatrix}") == "(determinant a b c d)");
}

TEST_CASE("rows of different lengths are bad syntax") {
  CHECK(parsed("\\begin{pmatrix}a&b\\\\c\\end{pmatrix}") == "<bad-syntax>");
}

TEST_CASE("cases alternate values and conditions") {
  CHECK(parsed("2\\begin{cases}1 & i = j\\\\ 0 & \\text{otherwise}\\end{cases}") ==
        "(term 2 (cases 1 \"i = j\" 0 \"\\text{otherwise}\"))");
  CHECK(parsed("2\\begin{cases}1,&i=j\\\\-1\\end{cases}") ==
        "(term 2 (cases 1 \"i=j\" (sum -1) \"otherwise\"))");
}

TEST_CASE("an environment that is not known is not read") {
  CHECK(parsed("\\begin{tikz}a\\end{tikz}") == "<unsupported>");
}

TEST_CASE("brackets nest as deep as is allowed, and deeper ones are refused without a crash") {
  const auto nested = [](int depth) { return parsed(repeated("(", depth) + "a" + repeated(")", depth)); };
  CHECK(nested(20).find("nesting-too-deep") == std::string::npos);
  CHECK(nested(max_nesting + 1).find("nesting-too-deep") != std::string::npos);
  CHECK(parsed(repeated("{", 50000)).find("nesting-too-deep") != std::string::npos);
  CHECK(parsed(repeated("\\hat", 50000)).find("nesting-too-deep") != std::string::npos);
}

TEST_CASE("states nested without end are refused without a crash") {
  for (const char* text :
       {"\\langle", "\\langle x|", "|x", "\\left|x", "\\left(x", "\\ket{", "|x\\rangle\\langle"}) {
    INFO(text);
    CHECK_FALSE(parsed(repeated(text, 50000) + "x").empty());
  }
}

TEST_CASE("a style over an expression is not read, over a zero it is") {
  CHECK(parsed("\\mathbf{a+b}") == "(sum +vector:a +vector:b)");
  CHECK(parsed("\\hat{\\hat{a}}") == "<unsupported>");
  CHECK(parsed("\\mathbf{0}") == "0");
  CHECK(parsed("\\mathbf{1}") == "<unsupported>");
}

TEST_CASE("words are not read as letters") {
  CHECK(parsed("\\text{torque}") == "<passed-over>");
  CHECK(parsed("\\mathrm{Ma}\\,a") == "(term <unsupported> a)");
}

TEST_CASE("square brackets around one letter group nothing", "[parse]") {
  CHECK(parsed("[a]") == "<ambiguous-reading>");
  CHECK(parsed("[a_1^{-1}]b") == "(term <ambiguous-reading> b)");
  CHECK(parsed("(a)") == "(group a)");
  CHECK(parsed("[a^2]") == "(group (power a 2))");
  CHECK(parsed("\\exp[a]") == "(exp a)");
}
