// SPDX-License-Identifier: GPL-3.0-or-later
#include "derive/notation/tidied.h"

#include "catch.h"
#include "check/entry/read_forms.h"
#include "check/form/forms.h"
#include "expr/print/print_latex.h"

using namespace rigor;

namespace {

/// The left side of an equation, tidied.
std::string left_tidied(const std::string& left) {
  SourceMap sources;
  FormsReading reading = read_forms_of_text(sources, "notes.md", "$$" + left + " = X$$", {});
  REQUIRE(reading.forms.chains.size() == 1);
  const auto expr = reading.forms.chains[0].forms[0].expr;
  REQUIRE(expr);
  const ExprId tidy = tidied(reading.forms.tree, *expr);
  return print_latex(reading.forms.tree, tidy, notation_at(reading.forms, reading.forms.chains[0]));
}

}  // namespace

TEST_CASE("a product in a product is one product, with its number first and no factor 1") {
  CHECK(left_tidied("a(2bc)") == "2 a b c");
  CHECK(left_tidied("a(b\\cdot 1)") == "a b");
  CHECK(left_tidied("a(b + c)") == "a(b + c)");
}

TEST_CASE("delta and epsilon with numbers are numbers") {
  CHECK(left_tidied("x\\delta_{11} + y\\delta_{21}") == "x");
  CHECK(left_tidied("x\\varepsilon_{213}") == "-x");
  CHECK(left_tidied("x\\delta_{12}") == "0");
}
