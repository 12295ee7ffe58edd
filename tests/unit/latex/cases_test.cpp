// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/split/cases.h"

#include "catch.h"
#include "latex/dump_syntax.h"
#include "latex/split/split.h"

namespace {

using namespace rigor;

/// `f = a if x > 0; f = b if x <= 0`
std::string cases(const std::string& text, const std::string& environment = "") {
  Stretch stretch(text);
  std::string dump;
  for (const WrittenChain& chain : split_display(stretch.tokens, environment, stretch.diagnostics)) {
    dump += (dump.empty() ? "" : "; ") + text_of(chain);
    for (const WrittenChain& condition : chain.assumed)
      dump += (&condition == &chain.assumed.front() ? " if " : ", ") + text_of(condition);
    if (chain.doubt) dump += " doubted";
  }
  return dump;
}

std::string two(const std::string& first, const std::string& second) {
  return cases("f = \\begin{cases} a & " + first + " \\\\ b & " + second + " \\end{cases}");
}

}  // namespace

TEST_CASE("each case is a statement under its condition") {
  CHECK(two("x > 0", "x \\le 0") == "f = a if x > 0; f = b if x \\le 0");
  CHECK(two("\\text{if } x > 0,", "\\text{for $x < 0$.}") == "f = a if x > 0; f = b if x < 0");
  CHECK(two("0 \\le x < L", "x \\in (L, M]") == "f = a if 0 \\le x < L; f = b if L < x, x \\le M");
  CHECK(cases("f = \\begin{cases} a, \\quad x > 0, \\\\ b, \\quad x < 0. \\end{cases}") ==
        "f = a if x > 0; f = b if x < 0");
  CHECK(cases("\\begin{rcases} a & x > 0 \\\\ b & x < 0 \\end{rcases} = f") ==
        "a = f if x > 0; b = f if x < 0");
  CHECK(cases("{f =} a & if $x > 0$ \\\\ b & if $x < 0$", "numcases") == "f = a if x > 0; f = b if x < 0");
}

TEST_CASE("otherwise is what the other cases leave") {
  CHECK(two("x > 0", "\\text{otherwise}") == "f = a if x > 0; f = b if x \\le 0");
  CHECK(two("x \\ne 0", "\\text{else.}") == "f = a if x \\ne 0; f = b if x = 0");
  CHECK(two("0 \\le x < L", "\\text{elsewhere}") ==
        "f = a if 0 \\le x < L; f = b if x < 0; f = b if x \\ge L");
  CHECK(two("x < 0 \\text{ or } x > L", "\\text{otherwise}") ==
        "f = a if x < 0; f = a if x > L; f = b if x \\ge 0, x \\le L");
  CHECK(cases("f = \\begin{cases} a & x < 0 \\\\ b & 0 \\le x < 2 \\\\ c & \\text{otherwise} \\end{cases}") ==
        "f = a if x < 0; f = b if 0 \\le x < 2; f = c if x \\ge 0, x \\ge 2");
}

TEST_CASE("a case in words that nobody knows is doubted, and so is what it leaves") {
  CHECK(two("x > 0", "\\text{at night}") == "f = a if x > 0; f = b doubted");
  CHECK(
      cases(
          "f = \\begin{cases} a & x < 0 \\\\ b & \\text{at night} \\\\ c & \\text{otherwise} \\end{cases}") ==
      "f = a if x < 0; f = b doubted; f = c doubted");
}

TEST_CASE("several sides by the same cases go together, and what is before them stays one statement") {
  const std::string rows = "& x > 0 \\\\ b & x < 0 \\end{cases}";
  CHECK(cases("f = \\begin{cases} a " + rows + " = \\begin{cases} c " + rows) ==
        "f = a = c if x > 0; f = b = b if x < 0");
  CHECK(cases("e = d = f = \\begin{cases} a " + rows) == "e = d = f; f = a if x > 0; f = b if x < 0");
  CHECK(cases("e = d, \\quad f = \\begin{cases} a " + rows) == "e = d; f = a if x > 0; f = b if x < 0");
}

TEST_CASE("cases of indices, other conditions and parts of a side are left as they are") {
  for (const char* text :
       {"f = \\begin{cases} 1 & i = j \\\\ 0 & i \\ne j \\end{cases}",
        "f = 2\\begin{cases} a & x > 0 \\\\ b & x < 0 \\end{cases}",
        "f = \\begin{cases} a & x > 0 \\\\ b & x < 0 \\end{cases} + 1",
        "f = \\begin{cases} a & x > 0 \\\\ b & x < 0 \\end{cases} = \\begin{cases} a & x > 1 "
        "\\\\ b & x < 0 \\end{cases}"}) {
    INFO(text);
    CHECK(cases(text).find("begin") != std::string::npos);
  }
}

TEST_CASE("a system in a brace is rows, as an array, too") {
  CHECK(cases("\\left\\{\\begin{array}{rcl} a &=& b \\\\ c &=& d \\end{array}\\right.") == "a = b; c = d");
  CHECK(cases("\\begin{cases} a = b \\\\ c = d \\end{cases}") == "a = b; c = d");
  CHECK(cases("\\begin{cases} a &= b \\\\ c + e &= d & e > 0 \\end{cases}") ==
        "a = b; c + e = d if e > 0 doubted");
  CHECK(cases("{} a = b \\\\ c = d", "numcases") == "a = b; c = d");
}
