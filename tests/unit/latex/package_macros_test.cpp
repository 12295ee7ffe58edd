// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/macro/package_macros.h"

#include "catch.h"
#include "latex/dump_syntax.h"

namespace {

using namespace rigor;

std::string written_out(const std::string& text) {
  const Stretch stretch(text);
  return stretch.diagnostics.empty() ? text_of(stretch.tokens) : stretch.diagnostics.back().message;
}

std::string parsed(const std::string& text) {
  Stretch stretch(text);
  SyntaxTree tree;
  const Tokens side = stretch.side();
  return dump_syntax(tree, parse_side(side, span_of(side), tree));
}

}  // namespace

TEST_CASE("matrices of physics are written out") {
  CHECK(written_out("\\pmqty{a & b \\\\ c & d}") == "\\begin{pmatrix}a & b \\\\ c & d\\end{pmatrix}");
  CHECK(written_out("\\mqty(a & (b) \\\\ c & d)") == "\\begin{pmatrix}a & (b) \\\\ c & d\\end{pmatrix}");
  CHECK(written_out("\\mqty[a]") == "\\begin{bmatrix}a\\end{bmatrix}");
  CHECK(written_out("\\smqty*|a|") == "\\begin{vmatrix}a\\end{vmatrix}");
  CHECK(written_out("\\mqty*{a}") == "\\begin{pmatrix}a\\end{pmatrix}");
  CHECK(written_out("\\mqty{a}") == "\\begin{matrix}a\\end{matrix}");
}

TEST_CASE("brackets of physics are written out, and end at the bracket of their own kind") {
  CHECK(written_out("\\qty(a(b + c))d") == "\\left(a(b + c)\\right)d");
  CHECK(written_out("\\qty\\big(a)") == "\\qty\\big(a)");
  CHECK(written_out("\\qty[a]\\ab|b|\\Bqty{c}") == "\\left[a\\right]\\left|b\\right|\\left\\{c\\right\\}");
  CHECK(written_out("\\abs[\\big]{x}") == "\\abs{x}");
  CHECK(written_out("\\eval{x}_{x=0}") == "\\left.x\\right|_{x=0}");
}

TEST_CASE("options of siunitx before two groups are no bracket") {
  CHECK(written_out("\\qty[mode=text]{3}{m}") == "\\qty[mode=text]{3}{m}");
  CHECK(parsed("\\qty[mode=text]{3}{m}") == parsed("\\qty{3}{m}"));
}

TEST_CASE("what a package does not expect behind its macro is left alone") {
  for (const char* text : {"\\pmqty", "\\pmqty a", "\\qty(a", "\\qty(a]", "\\mqty", "{\\pmqty}{a}",
                           "\\indices{ab}", "\\tensor{T}", "\\flatfrac{a}"}) {
    INFO(text);
    CHECK(written_out(text) == text);
  }
}

TEST_CASE("a definition of the author's comes before that of a package") {
  CHECK(written_out("\\newcommand{\\pmqty}[1]{<#1>}\\pmqty{a}") == "<a>");
  CHECK(written_out("\\let\\columns\\pmqty \\columns{a}") == "\\begin{pmatrix}a\\end{pmatrix}");
  CHECK(written_out("\\newcommand{\\q}[1]{\\pmqty{#1}}\\q{a}") == "\\begin{pmatrix}a\\end{pmatrix}");
}

TEST_CASE("indices of tensor have a column each") {
  CHECK(written_out("\\tensor{T}{^\\mu_\\nu}") == "{T}^\\mu{}_\\nu");
  CHECK(written_out("T\\indices*{_i_{jk}}") == "T_i{}_{jk}");
  CHECK(parsed("T\\indices{_i_j}") == parsed("T_{ij}"));
}

TEST_CASE("words of physics stand between wide spaces") {
  CHECK(written_out("a\\qif b") == "a\\quad\\text{if}\\quad b");
  CHECK(written_out("a\\qcomma b") == "a,\\quad b");
}

TEST_CASE("a macro of a package without braces stays one argument") {
  CHECK(written_out("\\frac\\pmqty{a}b") == "\\frac{\\begin{pmatrix}a\\end{pmatrix}}b");
}

TEST_CASE("macros of packages in each other are written out, up to a bound") {
  CHECK(written_out("\\qty(\\qty[\\pqty{a}])") == "\\left(\\left[\\left(a\\right)\\right]\\right)");
  std::string deep;
  for (int k = 0; k < 100'000; ++k) deep += "\\qty(";
  CHECK(written_out(deep) == deep);
}
