// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/hole/hole_text.h"

#include "catch.h"

namespace rigor {
namespace {

std::string put(const std::string& text, const std::string& answer, bool alone = false) {
  SourceMap sources;
  const FileId file = sources.add("statement", text);
  const auto begin = static_cast<std::uint32_t>(text.find("\\square"));
  const Span span{file, begin, begin + 7};
  return text.substr(0, begin) + placed(answer, place_of(sources, span, alone)) + text.substr(begin + 7);
}

}  // namespace

TEST_CASE("a sum gets brackets unless it stands alone") {
  CHECK(put("2\\square", "a + b") == "2\\left(a + b\\right)");
  CHECK(put("a = \\square", "a + b", true) == "a = a + b");
  CHECK(put("2\\square", "|a - b|") == "2\\left(|a - b|\\right)");
  CHECK(put("2\\,\\square", "\\frac{a + b}{c}") == "2\\,\\frac{a + b}{c}");
}

TEST_CASE("digits do not melt") {
  CHECK(put("2\\square", "3") == "2\\left(3\\right)");
  CHECK(put("m\\square\\,x", "1") == "m1\\,x");
}

TEST_CASE("letters do not go on with the name of a control") {
  CHECK(put("a\\cdot\\square", "b") == "a\\cdot b");
  CHECK(put("\\square x", "\\omega") == "\\omega x");
}

TEST_CASE("an argument is one group") {
  CHECK(put("\\frac12 + \\frac\\square2", "ab") == "\\frac12 + \\frac{ab}2");
  CHECK(put("\\frac{1}\\square", "ab") == "\\frac{1}{ab}");
  CHECK(put("e^\\square", "2t") == "e^{2t}");
}

TEST_CASE("blanks, braces and faces of words do not tell two texts apart") {
  CHECK(bare("T_{\\text{rot}}") == bare("T_{rot}"));
  CHECK(bare("a\\, b") == bare("ab"));
  CHECK(bare("a + b") != bare("a - b"));
}

}  // namespace rigor
