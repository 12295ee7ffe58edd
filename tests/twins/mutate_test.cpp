// SPDX-License-Identifier: GPL-3.0-or-later
#include "mutate.h"

#include <algorithm>

#include "catch.h"
#include "latex/token/token.h"

namespace rigor::twins {
namespace {

using Texts = std::vector<std::string>;

/// The side with each slip of one kind in it, in a statement that has no other side.
Texts slips(Slip slip, const std::string& side) {
  SourceMap sources;
  const FileId file = sources.add("side.tex", side);
  const Tokens tokens = lex(sources, {file, 0, static_cast<std::uint32_t>(side.size())});
  Texts texts;
  for (const Edit& edit : slips_of(sources, tokens, {tokens})) {
    if (edit.slip == slip) texts.push_back(with_edit(side, 0, edit));
  }
  return texts;
}

TEST_CASE("each sign is turned, and the first term gets one") {
  CHECK(slips(Slip::sign, "a + b") == Texts{"-a + b", "a - b"});
  CHECK(slips(Slip::sign, "-a") == Texts{"+a"});
  CHECK(slips(Slip::sign, "a(b - c)") == Texts{"-a(b - c)", "a(-b - c)", "a(b + c)"});
}

TEST_CASE("a written zero stays as it is") { CHECK(slips(Slip::sign, "0").empty()); }

TEST_CASE("signs are found across rows and in fractions") {
  CHECK(slips(Slip::sign, "a \\\\ &\\quad - b") == Texts{"-a \\\\ &\\quad - b", "a \\\\ &\\quad + b"});
  CHECK(slips(Slip::sign, "\\frac{a + b}{c}") ==
        Texts{"-\\frac{a + b}{c}", "\\frac{-a + b}{c}", "\\frac{a - b}{c}"});
}

TEST_CASE("unlike indices of one subscript are swapped") {
  CHECK(slips(Slip::indices_swapped, "I_{ij}") == Texts{"I_{ji}"});
  CHECK(slips(Slip::indices_swapped, "\\epsilon_{ijk}") ==
        Texts{"\\epsilon_{jik}", "\\epsilon_{kji}", "\\epsilon_{ikj}"});
  CHECK(slips(Slip::indices_swapped, "\\epsilon_{i23}") == Texts{"\\epsilon_{i32}"});
  CHECK(slips(Slip::indices_swapped, "I_{ii} r_{\\alpha i} T_{\\text{rot}}").empty());
}

TEST_CASE("an index is replaced by every other one of its kind") {
  CHECK(slips(Slip::index_replaced, "A_i B_j") == Texts{"A_j B_j", "A_i B_i"});
  CHECK(slips(Slip::index_replaced, "A_i r_{\\alpha 1} r_{\\alpha 2}") ==
        Texts{"A_i r_{\\alpha 2} r_{\\alpha 2}", "A_i r_{\\alpha 1} r_{\\alpha 1}"});
  CHECK(slips(Slip::index_replaced, "\\sum_j A_i B_i").empty());
}

TEST_CASE("the operands of a cross product change places with their brackets and scripts") {
  CHECK(slips(Slip::order, "\\mathbf{A}\\times\\mathbf{B}_\\alpha") ==
        Texts{" \\mathbf{B}_\\alpha \\times \\mathbf{A}"});
  CHECK(slips(Slip::order, "2\\,\\vec{a}\\times\\bigl(\\vec{b} + \\vec{c}\\bigr)") ==
        Texts{"2\\, \\bigl(\\vec{b} + \\vec{c}\\bigr) \\times \\vec{a}"});
  CHECK(slips(Slip::order, "\\vb{F}\\cross\\qty(\\vb{G})") == Texts{" \\qty(\\vb{G}) \\cross \\vb{F}"});
  CHECK(slips(Slip::cross_to_dot, "a \\times b") == Texts{"a \\cdot b"});
}

TEST_CASE("a term is doubled and halved, a number in it by its value") {
  CHECK(slips(Slip::factor, "ab") == Texts{"2\\cdot ab", "\\frac{1}{2}ab"});
  CHECK(slips(Slip::factor, "3x") == Texts{"6x", "\\frac{3}{2}x"});
}

TEST_CASE("a term is dropped with its sign") {
  CHECK(slips(Slip::term_dropped, "a + b - c") == Texts{" b - c", "a  - c", "a + b "});
  CHECK(slips(Slip::term_dropped, "a - b") == Texts{"- b", "a "});
  CHECK(slips(Slip::term_dropped, "abc").empty());
}

TEST_CASE("a square becomes the first and the third power") {
  CHECK(slips(Slip::power, "A^2") == Texts{"A ", "A^3"});
  CHECK(slips(Slip::power, "A^{2} b^4") == Texts{"A  b^4", "A^3 b^4"});
}

TEST_CASE("bars become brackets") {
  CHECK(slips(Slip::bars_dropped, "|a + b|^2") == Texts{"(a + b)^2"});
  CHECK(slips(Slip::bars_dropped, "\\left|\\frac{|a|}{b}\\right| \\norm{c}^2") ==
        Texts{"(\\frac{|a|}{b}) \\norm{c}^2", "\\left|\\frac{|a|}{b}\\right| (c)^2",
              "\\left|\\frac{(a)}{b}\\right| \\norm{c}^2"});
}

TEST_CASE("no slip comes twice and none changes nothing") {
  for (const Slip slip : {Slip::index_replaced, Slip::indices_swapped, Slip::order}) {
    Texts texts = slips(slip, "\\epsilon_{ijk} A_j B_k C_i C_i + \\mathbf{A}\\times\\mathbf{A}");
    CHECK(std::count(texts.begin(), texts.end(),
                     "\\epsilon_{ijk} A_j B_k C_i C_i + \\mathbf{A}\\times\\mathbf{A}") == 0);
    std::sort(texts.begin(), texts.end());
    CHECK(std::adjacent_find(texts.begin(), texts.end()) == texts.end());
  }
}

}  // namespace
}  // namespace rigor::twins
