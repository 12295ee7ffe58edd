// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/layout/typeset.h"

#include "catch.h"
#include "latex/written_box.h"

namespace rigor {
namespace {

std::string set(const std::string& text) {
  SourceMap sources;
  return to_typeset(layout_of(tokens_of(sources, text)));
}

}  // namespace

TEST_CASE("a control that nobody knows is words") {
  CHECK(set("\\foo") == "\\text{\\textbackslash{}foo}");
  CHECK(set("\\frac{a}{b}") == "\\frac{{a}}{{b}}");
}

TEST_CASE("words of a paragraph have no character that TeX would obey") {
  CHECK(typeset_words("50 % of #1 & {x}") == "50 \\% of \\#1 \\& \\{x\\}");
  CHECK(typeset_words("中") == "[U+4E2D]");
  CHECK(typeset_words("naïve α") == "naïve \\ensuremath{\\alpha }");
}

TEST_CASE("long lines are cut before relations and then before plus and minus") {
  SourceMap sources;
  const auto lines = [&](const std::string& text, double width) {
    std::vector<std::string> all;
    for (const Box& line : broken_lines(layout_of(tokens_of(sources, text)), width))
      all.push_back(to_plain_text(line));
    return all;
  };
  CHECK(lines("a = b + c", 100) == std::vector<std::string>{"a = b + c"});
  CHECK(lines("a = b = c", 2) == std::vector<std::string>{"a", "= b", "= c"});
  CHECK(lines("a = b + c - d", 3) == std::vector<std::string>{"a", "= b", "+ c", "− d"});
}

}  // namespace rigor
