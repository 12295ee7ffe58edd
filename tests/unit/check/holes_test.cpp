// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "catch.h"
#include "check/entry/read_forms.h"
#include "check/form/forms.h"

using namespace rigor;

namespace {

std::vector<WrittenHole> holes_of(const std::string& text) {
  SourceMap sources;
  FormRequest request;
  request.answer_holes = true;
  return read_forms_of_text(sources, "notes.md", text, request).holes;
}

std::string shape_of(const std::string& statement) {
  SourceMap sources;
  FormRequest request;
  request.answer_holes = true;
  const FormsReading reading = read_forms_of_text(sources, "notes.md", "$$" + statement + "$$\n", request);
  if (reading.holes.size() != 1 || reading.holes[0].readings.empty()) return "none";
  return dump(reading.forms.tree, reading.holes[0].readings[0].node);
}

}  // namespace

TEST_CASE("a hole takes the letters that are free on one side only") {
  CHECK(shape_of(R"(T = \tfrac12\,\square\,\omega_i\omega_j)") == R"(\square[i,j])");
  CHECK(shape_of(R"(B_j = \square\,A_i)") == R"(\square[j,i])");
  CHECK(shape_of(R"(A_i = \square)") == R"(\square[i])");
  CHECK(shape_of(R"(A_i = \square\,B_i)") == R"(\square)");
}

TEST_CASE("letters on a hole are its own") {
  CHECK(shape_of(R"(T = \tfrac12\,\square_{ij}\,\omega_i\omega_j)") == R"(\square[i,j])");
}

TEST_CASE("a hole in a sum takes the letters of its neighbours") {
  CHECK(shape_of(R"(A_i = B_i + \square)") == R"(\square[i])");
}

TEST_CASE("a hole is a scalar, a vector or a tensor as its place asks") {
  CHECK(shape_of(R"(|\mathbf{A}|^2 = \square)") == R"(\square)");
  CHECK(shape_of(R"(\mathbf{A}\times\square = \mathbf{C})") == R"(\square)");
  const auto holes = holes_of(R"($$\mathbf{L} = \square\cdot\boldsymbol{\omega}$$)");
  REQUIRE(holes.size() == 1);
  CHECK(holes[0].readings.size() == 2);  // a number before the vector, and a tensor
}

TEST_CASE("two holes in one expression are not read") {
  const auto holes = holes_of(R"($$A = \square + \square$$)");
  REQUIRE(holes.size() == 2);
  CHECK(holes[0].readings.empty());
  REQUIRE(holes[0].troubles.size() == 1);
  CHECK(holes[0].troubles[0].message == "one expression has 2 holes, but one equation determines only one");
}

TEST_CASE("a name is found by proof") {
  const auto holes = holes_of("$$S = (a + b)^2$$\n\n$$a^2 + 2ab + b^2 = \\square$$\n");
  REQUIRE(holes.size() == 1);
  REQUIRE(holes[0].readings.size() == 1);
  CHECK(holes[0].readings[0].names.size() == 1);
}

TEST_CASE("a name that is nearly right does not fit") {
  const auto holes = holes_of("$$S = (a + b)^2$$\n\n$$a^2 + 3ab + b^2 = \\square$$\n");
  REQUIRE(holes.size() == 1);
  REQUIRE(holes[0].readings.size() == 1);
  CHECK(holes[0].readings[0].names.empty());
}

TEST_CASE("what is multiplied by zero takes anything") {
  const auto holes = holes_of(R"($$(a - a)\square = 0$$)");
  REQUIRE(holes.size() == 1);
  REQUIRE_FALSE(holes[0].readings.empty());
  CHECK(holes[0].readings[0].takes_anything);
}
