// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/parse/parse_indices.h"

#include "catch.h"
#include "latex/dump_syntax.h"

namespace {

using namespace rigor;

std::string indices(const std::string& text) {
  const Stretch stretch(text);
  const IndexReading reading = read_indices(stretch.tokens);
  return reading.obstacle ? std::string(info(reading.obstacle->kind).name) : dump_indices(reading.indices);
}

std::string bounds(const std::string& lower, const std::string& upper = "") {
  const Stretch below(lower);
  const Stretch above(upper);
  const SumReading reading = read_sum_bounds(below.tokens, above.tokens);
  if (reading.obstacle) return std::string(info(reading.obstacle->kind).name);
  return dump_indices(reading.sum.indices) + " " + reading.sum.from + ".." + reading.sum.to;
}

}  // namespace

TEST_CASE("letters, Greek letters and digits are an index each") {
  CHECK(indices("ijk") == "[i,j,k]");
  CHECK(indices("\\alpha i") == "[\\alpha,i]");
  CHECK(indices("12") == "[1,2]");
  CHECK(indices("xy") == "[x,y]");
  CHECK(indices("i\\,j") == "[i,j]");
  CHECK(indices("{ij}k") == "[i,j,k]");
}

TEST_CASE("a prime belongs to the index before it") {
  CHECK(indices("i'j") == "[i',j]");
  CHECK(indices("ij''") == "[i,j'']");
  CHECK(indices("i^\\prime") == "[i']");
  CHECK(indices("'i") == "unsupported");
}

TEST_CASE("a word is one label") {
  CHECK(indices("\\text{rot}") == "[\"rot\"]");
  CHECK(indices("\\mathrm{cm}") == "[\"cm\"]");
  CHECK(indices("rot") == "[\"rot\"]");
  CHECK(indices("CM") == "[\"CM\"]");
  CHECK(indices("\\text{rot} 1") == "[\"rot\",1]");
}

TEST_CASE("letters that are no word are an index each") {
  CHECK(indices("mn") == "[m,n]");
  CHECK(indices("C") == "[C]");
  CHECK(indices("rots") == "[r,o,t,s]");
}

TEST_CASE("a sign can be a label") {
  CHECK(indices("\\perp") == "[\"\\perp\"]");
  CHECK(indices("+") == "[\"+\"]");
  CHECK(indices("\\odot") == "[\"\\odot\"]");
}

TEST_CASE("another quantity can be a label") {
  CHECK(indices("\\mathbf{k}") == "[\"\\mathbf{k}\"]");
  CHECK(indices("\\bm k") == "[\"\\mathbf{k}\"]");
  CHECK(indices("\\hat n") == "unsupported");
  CHECK(indices("\\hat r") == "[\"\\hat{r}\"]");
  CHECK(indices("\\hat\\mu") == "unsupported");
  CHECK(indices("x_0") == "[\"x_{0}\"]");
  CHECK(indices("E_{\\text{kin}}") == "[\"E_{\\text{kin}}\"]");
  CHECK(indices("i_1") == "unsupported");
  CHECK(indices("n_k") == "unsupported");
  CHECK(indices("(2)") == "[\"(2)\"]");
  CHECK(indices("(ij)") == "unsupported");
  CHECK(indices("B,0") == "[B,0]");
  CHECK(indices("A,B") == "[A,B]");
  CHECK(indices("1,2") == "unsupported");
  CHECK(indices("i\\to f") == "[\"i\\to f\"]");
}

TEST_CASE("a comma and a relation are no index") {
  CHECK(indices("i,j") == "unsupported");
  CHECK(indices("i=1") == "unsupported");
  CHECK(indices("i^2") == "unsupported");
}

TEST_CASE("nothing gives no index") { CHECK(indices(" ") == ""); }

TEST_CASE("an index knows where it stands") {
  const Stretch stretch("\\alpha i");
  CHECK(stretch.written(read_indices(stretch.tokens).indices.at(1).span) == "i");
}

TEST_CASE("braces in a subscript nest without a crash") {
  CHECK(indices(std::string(50000, '{')) == "unsupported");
}

TEST_CASE("the bounds of a sum are its letters, from and to") {
  CHECK(bounds("i") == "[i] ..");
  CHECK(bounds("i=1", "3") == "[i] 1..3");
  CHECK(bounds("i,j") == "[i,j] ..");
  CHECK(bounds("\\alpha = 1", "N") == "[\\alpha] 1..N");
}

TEST_CASE("a sum over a condition or over nothing is not read") {
  CHECK(bounds("i<j") == "unsupported");
  CHECK(bounds("i \\ne j") == "unsupported");
  CHECK(bounds("") == "unsupported");
}
