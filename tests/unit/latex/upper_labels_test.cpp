// SPDX-License-Identifier: GPL-3.0-or-later
// Labels above letters.
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

TEST_CASE("words, numbers and capitals in brackets above a letter are its label") {
  CHECK(parsed("E^{(1)}_n") == parsed("E_n^{(1)}"));
  CHECK(parsed("E^{(1)}_n") == "E[\"^{(1)}\",n]");
  CHECK(parsed("x^{\\mathrm{lab}}") == parsed("x^{\\text{lab}}"));
  CHECK(parsed("x^{\\rm lab}") == parsed("x^{\\text{lab}}"));
  CHECK(parsed("I^{(P)}") == "I[\"^{(P)}\"]");
  CHECK(parsed("x^{\\max}") == "x[\"^{\\max}\"]");
}

TEST_CASE("what can be a power, an index, a transpose or a derivative above a letter is no label") {
  for (const char* text :
       {"x^{(n)}", "x^{(-1)}", "x^{(1/2)}", "x^{(123)}", "A^{\\mathrm T}", "A^{\\text{T}}", "e^{(1)}",
        "f^{(2)}(x)", "\\delta^{(3)}", "\\mathbf x^{(1)}", "\\dot x^{(1)}", "x'^{(1)}", "\\hat x^{(1)}",
        "2^{(1)}", "e^{\\mathrm i x}", "x^{\\text{a b}}", "n^{\\text{th}}"}) {
    INFO(text);
    CHECK(parsed(text).find("[\"^") == std::string::npos);
  }
}
