// SPDX-License-Identifier: GPL-3.0-or-later
// Sides that can be read in two ways.
#include "latex/reading/readings.h"

#include "catch.h"
#include "latex/dump_syntax.h"

namespace {

using namespace rigor;

/// All readings of one side, the plain one first.
std::vector<std::string> readings_of(const std::string& text) {
  Stretch stretch(text);
  SyntaxTree tree;
  WrittenChain chain;
  const Tokens side = stretch.side();
  chain.sides.push_back({side, span_of(side)});
  const Readings readings = parse_readings(chain, tree);
  std::vector<std::string> all{dump_syntax(tree, readings.sides[0])};
  for (const auto& other : readings.others) all.push_back(dump_syntax(tree, other[0]));
  return all;
}

using All = std::vector<std::string>;

}  // namespace

TEST_CASE("a bracket behind the letters of an argument belongs to it or not") {
  CHECK(readings_of("\\cos\\omega(t-s)") ==
        All{"(term (cos \\omega) (group (sum +t -s)))", "(cos (term \\omega (group (sum +t -s))))"});
  CHECK(readings_of("\\cos(\\omega)(t-s)").size() == 1);
  CHECK(readings_of("\\sin\\theta(1+\\cos\\theta)").size() == 1);
  CHECK(readings_of("\\sin\\theta(\\mathbf a+\\mathbf b)").size() == 1);
}

TEST_CASE("an argument ends behind an angle or before a blank, or goes on") {
  CHECK(readings_of("\\cos\\theta r") == All{"(cos (term \\theta r))", "(term (cos \\theta) r)"});
  CHECK(readings_of("\\exp a b") == All{"(exp (term a b))", "(term (exp a) b)"});
  CHECK(readings_of("\\exp ab").size() == 1);
  CHECK(readings_of("\\sin\\omega t").size() == 1);
  CHECK(readings_of("\\cos\\theta\\hat r") == All{"(term (cos \\theta) hat:r)"});
}

TEST_CASE("four bars can stand beside one another or in one another") {
  CHECK(readings_of("|a|b|c|") == All{"(term (bars a) b (bars c))", "(bars (term a (bars b) c))"});
  CHECK(readings_of("|a|\\,|b|").size() == 1);
  CHECK(readings_of("|a| - b|c|").size() == 1);
}

TEST_CASE("behind a slash between numbers a letter is divided by or not, unless a blank keeps it apart") {
  CHECK(readings_of("1/2r") == All{"(term 1 /2 r)", "(term 1 /(group (term 2 r)))"});
  CHECK(readings_of("1/2 r").size() == 1);
  CHECK(readings_of("1/2\\,r").size() == 1);
}

TEST_CASE("two places have four readings, of three or more only two are given") {
  CHECK(readings_of("\\cos\\theta r + 1/2r").size() == 4);
  CHECK(readings_of("\\cos\\theta r + 1/2r + |a|b|c|").size() == 2);
}
