// SPDX-License-Identifier: GPL-3.0-or-later
// Sums, products, letters and scripts; brackets and environments are in parser_brackets_test.cpp.
#include "latex/parse/parse.h"

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

}  // namespace

TEST_CASE("terms keep the sign before them") {
  CHECK(parsed("a+b-c") == "(sum +a +b -c)");
  CHECK(parsed("-a") == "(sum -a)");
  CHECK(parsed("+a") == "a");
  CHECK(parsed("a−b") == "(sum +a -b)");
}

TEST_CASE("two signs in a row are one") {
  CHECK(parsed("a--b") == "(sum +a +b)");
  CHECK(parsed("a+-b") == "(sum +a -b)");
  CHECK(parsed("a---b") == "(sum +a -b)");
}

TEST_CASE("a sign behind a product sign belongs to the factor") {
  CHECK(parsed("\\mathbf{A}\\times-\\mathbf{B}") == "(term vector:A ×(sum -vector:B))");
  CHECK(parsed("a\\cdot-b c") == "(term a ·(sum -b) c)");
}

TEST_CASE("the factors of a term stand in a row as written") {
  CHECK(parsed("a b\\cdot c\\times d/e") == "(term a b ·c ×d /e)");
  CHECK(parsed("\\mathbf A\\cross\\mathbf B\\vdot\\mathbf C") == "(term vector:A ×vector:B ·vector:C)");
  CHECK(parsed("a·b×c") == "(term a ·b ×c)");
  CHECK(parsed("a/bc") == "(term a /b c)");
}

TEST_CASE("spacing between factors means nothing") {
  CHECK(parsed("a\\,b\\;c\\quad d~e\\displaystyle f") == "(term a b c d e f)");
}

TEST_CASE("numbers are digits with at most one point") {
  CHECK(parsed("1.5a") == "(term 1.5 a)");
  CHECK(parsed("12b") == "(term 12 b)");
  CHECK(parsed(".5") == "0.5");
}

TEST_CASE("a letter with its face and accent is one symbol") {
  CHECK(parsed("\\mathbf A") == "vector:A");
  CHECK(parsed("\\vec{r}\\cdot\\boldsymbol\\omega") == "(term vector:r ·vector:\\omega)");
  CHECK(parsed("\\hat{\\mathbf{n}}") == "vector:hat:n");
  CHECK(parsed("\\hat\\mathbf n") == "vector:hat:n");
  CHECK(parsed("\\vu{n}") == "vector:hat:n");
  CHECK(parsed("\\hat\\imath \\bar x \\tilde y") == "(term hat:\\imath bar:x tilde:y)");
  CHECK(parsed("\\vb*{A}\\cross\\vb{B}") == "(term vector:A ×vector:B)");
  CHECK(parsed("\\mathbf{AB}") == "vector:AB");
}

TEST_CASE("arrows on both sides make a tensor") {
  CHECK(parsed("\\overleftrightarrow{\\mathbf I}\\cdot\\boldsymbol\\omega") ==
        "(term tensor:I ·vector:\\omega)");
  CHECK(parsed("\\overset{\\leftrightarrow}{I}") == "tensor:I");
}

TEST_CASE("the forms of epsilon are one letter, and so are signs and their names") {
  CHECK(parsed("\\varepsilon_{ijk}\\epsilon_{ilm}") == "(term \\epsilon[i,j,k] \\epsilon[i,l,m])");
  CHECK(parsed("α ω ε") == parsed("\\alpha \\omega \\epsilon"));
}

TEST_CASE("subscripts and primes belong to the letter before them") {
  CHECK(parsed("\\vec{r}_{\\alpha i}") == "vector:r[\\alpha,i]");
  CHECK(parsed("A'_i") == "A'[i]");
  CHECK(parsed("A^{\\prime}_i") == "A'[i]");
  CHECK(parsed("x''") == "x''");
  CHECK(parsed("A_{i'j}") == "A[i',j]");
  CHECK(parsed("T_{\\text{rot}}") == "T[\"rot\"]");
  CHECK(parsed("A_i B_j") == "(term A[i] B[j])");
}

TEST_CASE("a superscript is a power of all that it stands on") {
  CHECK(parsed("A^2") == "(power A 2)");
  CHECK(parsed("A_i^2") == "(power A[i] 2)");
  CHECK(parsed("(a+b)^{-1}") == "(power (group (sum +a +b)) (sum -1))");
  CHECK(parsed("ab^2") == "(term a (power b 2))");
  CHECK(parsed("A'^2") == "(power A' 2)");
  CHECK(parsed("A^2_i") == "(power A[i] 2)");
}

TEST_CASE("a transpose or an adjoint is no power") {
  CHECK(parsed("A^+") == "<unsupported>");
  for (const char* mark : {"\\dagger", "\\dag", "{\\dagger}"}) {
    INFO(mark);
    CHECK(parsed(std::string("A^") + mark) == "(adjoint A)");
  }
  for (const char* mark : {"T", "\\top", "{\\mathrm T}", "{\\mathsf{T}}"}) {
    INFO(mark);
    CHECK(parsed(std::string("A^") + mark) == "(transpose A)");
  }
}

TEST_CASE("a dagger is an adjoint, on the letter with its indices") {
  CHECK(parsed("A^\\dagger") == "(adjoint A)");
  CHECK(parsed("a^{\\dag}_k") == "(adjoint a[k])");
  CHECK(parsed("a^{\\dagger 2}") == "(power (adjoint a) 2)");
}

TEST_CASE("a star above is a conjugate, on the letter with its indices") {
  for (const char* mark : {"*", "{*}", "\\ast", "{\\star}"}) {
    INFO(mark);
    CHECK(parsed(std::string("A^") + mark) == "(conjugate A)");
  }
  CHECK(parsed("A_n^*") == parsed("A^*_n"));
  CHECK(parsed("(a + b)^*") == "(conjugate (group (sum +a +b)))");
  CHECK(parsed("\\overline{a + b}") == "(bar (sum +a +b))");
  CHECK(parsed("\\bar a") == "bar:a");
}

TEST_CASE("fractions and square roots take their arguments") {
  CHECK(parsed("\\frac{1}{2}mv^2") == "(term (fraction 1 2) m (power v 2))");
  CHECK(parsed("\\tfrac12 m") == "(term (fraction 1 2) m)");
  CHECK(parsed("\\sqrt{a+b}") == "(root (sum +a +b))");
  CHECK(parsed("\\sqrt[2]{a}") == "(root a)");
  CHECK(parsed("\\sqrt[3]{a}") == "<unsupported>");
}

TEST_CASE("a sum takes the rest of its term") {
  CHECK(parsed("\\sum_i A_i B_i + C") == "(sum +(sum over [i] (term A[i] B[i])) +C)");
  CHECK(parsed("2\\sum_i A_i\\cdot B") == "(term 2 (sum over [i] (term A[i] ·B)))");
  CHECK(parsed("\\sum_{i=1}^3 A_iB_i") == "(sum over [i] from 1 to 3 (term A[i] B[i]))");
  CHECK(parsed("\\sum\\limits_{i,j} A_{ij}") == "(sum over [i,j] A[i,j])");
  CHECK(parsed("\\sum_\\alpha m_\\alpha\\sum_\\beta m_\\beta - x") ==
        "(sum +(sum over [\\alpha] (term m[\\alpha] (sum over [\\beta] m[\\beta]))) -x)");
}

TEST_CASE("a sum without a summand or an index is not read") {
  CHECK(parsed("\\sum_i") == "<bad-syntax>");
  CHECK(parsed("\\sum A_i + B") == "(sum +<unsupported> +B)");
  CHECK(parsed("\\sum_{i<j} A_{ij}") == "<unsupported>");
}

TEST_CASE("what is not read leaves the rest readable") {
  CHECK(parsed("\\max x") == "(term <unsupported> x)");
  CHECK(parsed("a \\pm b") == "(term a <unsupported> b)");
  CHECK(parsed("\\foo a") == "(term <unsupported> a)");
}

TEST_CASE("an operand that is missing is bad syntax at its sign") {
  CHECK(parsed("a +") == "(sum +a +<bad-syntax>)");
  CHECK(parsed("a \\cdot") == "(term a ·<bad-syntax>)");
  CHECK(parsed("\\cdot a") == "(term <bad-syntax> ·a)");
  CHECK(parsed("a \\times\\cdot b") == "(term a ×<bad-syntax> ·b)");
  CHECK(parsed("^2") == "<unsupported>");  // `{}^2H`, or what a macro has left
  CHECK(parsed("") == "<bad-syntax>");
}

TEST_CASE("braces that hold nothing or only a sign are not there") {
  CHECK(parsed("A_{}") == "A");
  CHECK(parsed("A_{}B^{}") == parsed("AB"));
  CHECK(parsed("a{+}b") == parsed("a+b"));
  CHECK(parsed("a{\\cdot}b") == parsed("a\\cdot b"));
  CHECK(parsed("\\frac{a}{b}{\\cdot}c") == parsed("\\frac{a}{b}\\cdot c"));
  CHECK(parsed("\\sin{}(a)") == parsed("\\sin(a)"));
  CHECK(parsed("\\frac{}{b}") != parsed("\\frac b"));
}

TEST_CASE("an empty group means nothing") {
  CHECK(parsed("{}-a") == "(sum -a)");
  CHECK(parsed("{}a") == "a");
}

TEST_CASE("a node has the span that its author typed") {
  Stretch stretch("a + \\mathbf{B}\\times \\mathbf{C}");
  SyntaxTree tree;
  const SyntaxId sum = parse_side(stretch.tokens, {}, tree);
  CHECK(stretch.written(tree[sum].span) == "a + \\mathbf{B}\\times \\mathbf{C}");
  const SyntaxId term = tree.child(sum, 1);
  CHECK(stretch.written(tree[term].span) == "\\mathbf{B}\\times \\mathbf{C}");
  CHECK(stretch.written(tree.children(term)[1].joint_span) == "\\times");
  CHECK(stretch.written(tree[tree.child(term, 1)].span) == "\\mathbf{C}");
}

TEST_CASE("the span of a symbol has its scripts with their braces") {
  for (const char* text : {"\\vec{r}_{\\alpha i}", "T_{\\text{rot}}", "A_{i}^{2}", "A'_{ij}"}) {
    Stretch stretch(text);
    SyntaxTree tree;
    CHECK(stretch.written(tree[parse_side(stretch.tokens, {}, tree)].span) == text);
  }
}

TEST_CASE("a node that came out of a macro has the span of the call") {
  Stretch stretch("\\newcommand{\\v}[1]{\\mathbf{#1}}\\newcommand{\\ab}{a + b}\\v{A}\\times\\v C - (\\ab)");
  SyntaxTree tree;
  const SyntaxId sum = parse_side(stretch.tokens, {}, tree);
  CHECK(dump_syntax(tree, sum) == "(sum +(term vector:A ×vector:C) -(group (sum +a +b)))");
  const SyntaxId term = tree.child(sum, 0);
  CHECK(stretch.written(tree[tree.child(term, 0)].span) == "\\v{A}");
  CHECK(stretch.written(tree[tree.child(term, 1)].span) == "\\v C");
  CHECK(stretch.written(tree[tree.child(tree.child(sum, 1), 0)].span) == "\\ab");
}
