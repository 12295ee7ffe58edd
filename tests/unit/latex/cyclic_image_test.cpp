// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/reading/cyclic_image.h"

#include "catch.h"
#include "latex/dump_syntax.h"
#include "latex/parse/parse.h"

using namespace rigor;

namespace {

std::string image_of(const std::string& text, int times = 1) {
  Stretch stretch(text);
  const Tokens side = stretch.side();
  SyntaxTree syntax;
  SyntaxId id = parse_side(side, span_of(side), syntax);
  const WrittenAxes axes = axes_in(syntax, {id});
  if (axes.obstacle)
    return std::string(info(axes.obstacle->kind).name) + " at " + stretch.written(axes.place);
  for (int image = 0; image < times; ++image) id = cyclic_image(syntax, id, axes);
  return dump_syntax(syntax, id);
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

TEST_CASE("a cyclic image turns what derivatives are by") {
  CHECK(image_of("\\partial_y A_z - \\partial_z A_y") == reading_of("\\partial_z A_x - \\partial_x A_z"));
  CHECK(image_of("\\frac{\\partial f}{\\partial x}") == reading_of("\\frac{\\partial f}{\\partial y}"));
  CHECK(image_of("\\partial_1 A_2") == reading_of("\\partial_2 A_3"));
  CHECK(image_of("\\frac{\\partial f}{\\partial x_3}") == reading_of("\\frac{\\partial f}{\\partial x_1}"));
}

TEST_CASE("a cyclic image turns unit vectors along the axes") {
  CHECK(image_of("\\hat{x}\\times\\hat{\\mathbf{y}}") == reading_of("\\hat{y}\\times\\hat{\\mathbf{z}}"));
  CHECK(image_of("\\hat{i}\\times\\hat{k}") == reading_of("\\hat{j}\\times\\hat{i}"));
  CHECK(image_of("\\hat{\\imath}\\times\\hat{k}") == reading_of("\\hat{\\jmath}\\times\\hat{\\imath}"));
  CHECK(image_of("A_i\\hat{\\mathbf{i}} + i + k_j") == reading_of("A_i\\hat{\\mathbf{j}} + i + k_j"));
}

TEST_CASE("a cyclic image turns coordinates where x, y, z are the axes") {
  CHECK(image_of("y p_z - z\\dot{p}_y") == reading_of("z p_x - x\\dot{p}_z"));
  CHECK(image_of("L_x - y_\\alpha\\dot{z}_\\alpha - z_{\\text{cm}}'") ==
        reading_of("L_y - z_\\alpha\\dot{x}_\\alpha - x_{\\text{cm}}'"));
  CHECK(image_of("A_1 x + x_2 - \\mathbf{x}_3") == reading_of("A_2 x + x_3 - \\mathbf{x}_1"));
  CHECK(image_of("A_x \\mathbf{x} + x_i") == reading_of("A_y \\mathbf{x} + x_i"));
}

TEST_CASE("where nothing is an axis there is no image") {
  for (const char* text : {"\\frac{1}{2}A_i^2 + 3", "x + y + z", "\\mathbf{x}", "A_4 i j k", "x_i"}) {
    INFO(text);
    CHECK(image_of(text) == std::string("unsupported at ") + text);
  }
}

TEST_CASE("a sign that may be an axis or not has no image") {
  CHECK(image_of("y_1 A_x") == "ambiguous-reading at y_1");
  CHECK(image_of("m p_{1z}") == "ambiguous-reading at p_{1z}");
  CHECK(image_of("I_1\\omega_x") == "ambiguous-reading at I_1");
  CHECK(image_of("y_n A_x") == "ambiguous-reading at y_n");
  CHECK(image_of("A_x\\hat{k}") == "ambiguous-reading at \\hat{k}");
  CHECK(image_of("y p_3 - z p_2") == "ambiguous-reading at y");
  CHECK(image_of("\\mathbf{e}_1 A_x + \\partial_2 A_x") == reading_of("\\mathbf{e}_2 A_y + \\partial_3 A_y"));
}

TEST_CASE("three cyclic images are the expression itself") {
  for (const char* text : {"\\mathbf{e}_1\\times\\mathbf{e}_2 - (A)_{3}B_{y}", "\\hat{\\imath}\\hat{k} - A_3",
                           "\\hat{i}\\hat{k}", "\\partial_x y + \\hat{z}"}) {
    INFO(text);
    CHECK(image_of(text, 3) == reading_of(text));
    CHECK(image_of(text, 2) != reading_of(text));
  }
}
