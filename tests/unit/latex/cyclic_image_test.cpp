// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/cyclic_image.h"

#include "catch.h"
#include "latex/dump_syntax.h"
#include "latex/parse.h"

using namespace rigor;

namespace {

std::string image_of(const std::string& text) {
  Stretch stretch(text);
  const Tokens side = stretch.side();
  SyntaxTree syntax;
  return dump_syntax(syntax, cyclic_image(syntax, parse_side(side, span_of(side), syntax)));
}

std::string reading_of(const std::string& text) {
  Stretch stretch(text);
  const Tokens side = stretch.side();
  SyntaxTree syntax;
  return dump_syntax(syntax, parse_side(side, span_of(side), syntax));
}

}  // namespace

TEST_CASE("a cyclic image turns the axes in all subscripts") {
  CHECK(image_of("I_1\\dot\\omega_1 - (I_2-I_3)\\omega_2\\omega_3") ==
        reading_of("I_2\\dot\\omega_2 - (I_3-I_1)\\omega_3\\omega_1"));
  CHECK(image_of("L_x") == reading_of("L_y"));
  CHECK(image_of("L_z") == reading_of("L_x"));
  CHECK(image_of("I_{12}") == reading_of("I_{23}"));
}

TEST_CASE("numbers that are no subscripts, and letters, stay") {
  CHECK(image_of("\\frac{1}{2}A_i^2 + 3") == reading_of("\\frac{1}{2}A_i^2 + 3"));
}

TEST_CASE("three cyclic images are the expression itself") {
  const std::string text = "\\mathbf{e}_1\\times\\mathbf{e}_2 - A_{3}B_{y}";
  Stretch stretch(text);
  const Tokens side = stretch.side();
  SyntaxTree syntax;
  SyntaxId id = parse_side(side, span_of(side), syntax);
  const std::string before = dump_syntax(syntax, id);
  for (int image = 0; image < 3; ++image) id = cyclic_image(syntax, id);
  CHECK(dump_syntax(syntax, id) == before);
}
