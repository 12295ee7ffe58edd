// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/reading/pieces.h"

#include "catch.h"
#include "latex/token/token.h"

using namespace rigor;

namespace {

/// The terms of each level that may be a sum, levels apart by `|`, terms by `,`.
std::string cut(const std::string& side) {
  SourceMap sources;
  const FileId file = sources.add("side.tex", side);
  const Tokens tokens = lex(sources, {file, 0, static_cast<std::uint32_t>(side.size())});
  std::string text;
  for (const PieceLevel& level : levels_of(tokens)) {
    if (!level.may_be_sum) continue;
    std::string terms;
    for (const PieceTerm& term : terms_of(level)) {
      terms += terms.empty() ? "" : ", ";
      if (term.sign != nullptr) terms += term.sign->kind == PieceKind::minus ? "-" : "+";
      terms += text_of(term.tokens);
    }
    text += (text.empty() ? "" : " | ") + terms;
  }
  return text;
}

}  // namespace

TEST_CASE("a side is cut into terms, and what stands in brackets into its own") {
  CHECK(cut("a + 2bc - d") == "a, +2bc, -d");
  CHECK(cut("m(a - b) + c") == "m(a - b), +c | a, -b");
  CHECK(cut("\\frac{a + b}{c}") == "\\frac{a + b}{c} | a, +b | c");
  CHECK(cut("|a - b|^2") == "|a - b|^2 | a, -b");
  CHECK(cut("\\sqrt{a + b}") == "\\sqrt{a + b} | a, +b");
}

TEST_CASE("the letter under a face is no sum") {
  CHECK(cut("\\mathbf{A} + \\vec{B}") == "\\mathbf{A}, +\\vec{B}");
}

TEST_CASE("a sum over particles takes the rest of its term") {
  CHECK(cut("\\sum_\\alpha m_\\alpha + M") == "\\sum_\\alpha m_\\alpha, +M");
}

TEST_CASE("line breaks and alignment are no part of a term") { CHECK(cut("a \\\\ &\\quad + b") == "a, +b"); }
