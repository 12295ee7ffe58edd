// SPDX-License-Identifier: GPL-3.0-or-later
// What a claim's question holds, seen from the verdicts: definitions, assumptions and their derivatives.
#include "check/question/question.h"

#include "catch.h"
#include "check/checked.h"

using namespace rigor;

namespace {

const std::string vectors = rigor_says("vector \\mathbf{r}, \\mathbf{A}");
const std::string scalars = rigor_says("scalar a, b, x, y");

std::string with(const std::string& directives, const std::string& statement) {
  return verdict_on(statement, directives);
}
std::string with_claim(const std::string& directives, const std::string& statement) {
  return verdict_on_claim(statement, directives);
}
bool is_refuted(const std::string& line) { return line.starts_with("refuted"); }

}  // namespace

TEST_CASE("a definition defines its derivatives") {
  const std::string notes = rigor_says("constant A, k") + "$$x = A\\cos(kt)$$\n\n";
  CHECK(with(notes, "\\dot x = -kA\\sin(kt)") == "proved");
  CHECK(with(notes, "\\ddot x = -k^2x") == "proved");
  CHECK(is_refuted(with_claim(notes, "\\ddot x = k^2x")));
}

TEST_CASE("an assumption holds at all times, so its derivatives do") {
  const std::string notes =
      vectors + rigor_says("constant a") + rigor_says("given \\mathbf{r}\\cdot\\mathbf{r} = a^2");
  CHECK(with(notes, "\\mathbf{r}\\cdot\\dot{\\mathbf{r}} = 0") == "proved");
  CHECK(with(notes, "\\mathbf{r}\\cdot\\ddot{\\mathbf{r}} = -\\dot{\\mathbf{r}}\\cdot\\dot{\\mathbf{r}}") ==
        "proved");
  CHECK(is_refuted(with_claim(notes, "\\mathbf{r}\\cdot\\ddot{\\mathbf{r}} = 0")));
}

TEST_CASE("an order at all times says nothing of rates") {
  CHECK(is_refuted(with_claim(scalars + rigor_says("given a < b"), "\\dot a < \\dot b")));
}

TEST_CASE("what only an assumption's derivative shows is looked for") {
  const std::string notes = vectors + rigor_says("given \\dot{\\mathbf{r}} = \\mathbf{A}\\times\\mathbf{r}") +
                            rigor_says("given \\dot{\\mathbf{A}} = 0");
  CHECK(with(notes, "\\ddot{\\mathbf{r}} = \\mathbf{A}\\times(\\mathbf{A}\\times\\mathbf{r})") == "proved");
  CHECK(is_refuted(with_claim(notes, "\\ddot{\\mathbf{r}} = \\mathbf{A}\\times\\mathbf{r}")));
}

TEST_CASE("before a claim is refuted, assumptions are differentiated once more than it is") {
  const std::string square = scalars + rigor_says("given x^2 = 0");
  CHECK(with(square, "\\dot x = 0") == "proved");
  CHECK(is_refuted(with_claim(square, "\\dot x = \\dot y")));
  const std::string circle = scalars + rigor_says("given x^2 + y^2 = 0");
  CHECK_FALSE(is_refuted(with(circle, "\\dot x^2 + \\dot y^2 = 0")));
  const std::string length = vectors + rigor_says("given A^2 = 0");
  CHECK_FALSE(is_refuted(with(length, "\\dot{\\mathbf{A}} = 0")));
  CHECK_FALSE(is_refuted(with(length, "\\dot{\\mathbf{A}}\\cdot\\dot{\\mathbf{A}} = 0")));
  const std::string field = scalars + rigor_says("given a^2 = 0");
  CHECK(with(field, "\\partial_x a = 0") == "proved");
  CHECK(is_refuted(with_claim(field, "\\partial_x a = \\partial_x b")));
}

TEST_CASE("a rule is followed as often as it can be") {
  const std::string notes = scalars + rigor_says("given \\dot x = y") + rigor_says("given \\dot y = x + 1");
  CHECK(with(notes, "\\ddot x = x + 1") == "proved");
  CHECK(is_refuted(with_claim(notes, "\\ddot x = x")));
}

TEST_CASE("the rate of a constant is zero") {
  CHECK(with(scalars + rigor_says("constant a"), "\\frac{d}{dt}(ax) = a\\dot x") == "proved");
  CHECK(is_refuted(with_claim(scalars + rigor_says("constant a"), "\\frac{d}{dt}(ax) = 2a\\dot x")));
  CHECK(with(vectors + rigor_says("constant r_3"), "\\dot r_3 = 0") == "proved");
}

TEST_CASE("a unit vector's rate is perpendicular to it, at every order") {
  const std::string unit = rigor_says("unit vector \\mathbf{n}");
  CHECK(with(unit, "\\mathbf{n}\\cdot\\dot{\\mathbf{n}} = 0") == "proved");
  CHECK(with(unit, "\\mathbf{n}\\cdot\\ddot{\\mathbf{n}} = -|\\dot{\\mathbf{n}}|^2") == "proved");
  CHECK(is_refuted(with_claim(unit, "\\mathbf{n}\\cdot\\ddot{\\mathbf{n}} = 0")));
}

TEST_CASE("what is small is zero to zeroth order, in whatever order it is said") {
  CHECK(with(rigor_says("small x"), "(1+x)^2 \\approx 1 + 2x") == "proved");
  CHECK(with(rigor_says("small x") + rigor_says("scalar x"), "(1+x)^2 \\approx 1 + 2x") == "proved");
  CHECK(with(rigor_says("scalar x") + rigor_says("small x"), "\\frac{1}{1+x} \\approx 1 - x") == "proved");
  CHECK(is_refuted(with_claim(rigor_says("scalar x") + rigor_says("small x"), "(1+x)^2 \\approx 1 + x")));
}

TEST_CASE("a constant and the time can be small") {
  const std::string notes = rigor_says("scalar x") + rigor_says("constant x") + rigor_says("small x");
  CHECK(with(notes, "(1+x)^2 \\approx 1 + 2x") == "proved");
  CHECK(is_refuted(with_claim(notes, "(1+x)^2 \\approx 1 + 3x")));
  CHECK(with(rigor_says("small t"), "(1+t)^2 \\approx 1") != "proved");
}

TEST_CASE("what is defined through something small is small, too") {
  const std::string notes = scalars + rigor_says("small x") + rigor_says("let b = ax");
  CHECK(with(notes, "b^2 \\approx 0") == "proved");
  CHECK(is_refuted(with_claim(notes, "b \\approx 0")));
}

TEST_CASE("what is defined can be small itself") {
  const std::string let = rigor_says("let b = x - y");
  const std::string small = rigor_says("small b");
  for (const std::string& notes : {scalars + let + small, scalars + small + let}) {
    CHECK(with(notes, "b^2 \\approx 0") == "proved");
    CHECK(with(notes, "x^2 \\approx y^2 + 2yb") == "proved");
    CHECK(with(notes, "b\\dot b \\approx 0") == "proved");
    CHECK(is_refuted(with_claim(notes, "x^2 \\approx y^2 + yb")));
    CHECK(is_refuted(with_claim(notes, "x^2 \\approx y^2")));
    CHECK(is_refuted(with_claim(notes, "x \\approx y")));
  }
}

TEST_CASE("a small divisor proves nothing") {
  const std::string notes = rigor_says("scalar x, y") + rigor_says("small x, y");
  for (const char* statement : {"\\frac{x^2}{x} \\approx 0", "\\frac{x}{y} \\approx 0",
                                "\\sqrt{x} \\approx 0", "\\sqrt{x^2} \\approx 0", "|x| \\approx 2x"}) {
    INFO(statement);
    CHECK(with(notes, statement) != "proved");
  }
}

TEST_CASE("a definition defines its derivatives of high order, too") {
  const std::string notes =
      rigor_says("scalar a, b, x") + rigor_says("constant a") + rigor_says("let y = a t^2");
  CHECK(with(notes, "\\frac{d^9}{dt^9}y = 0") == "proved");
  CHECK(is_refuted(with_claim(notes, "\\frac{d^9}{dt^9}y = a")));
}

TEST_CASE("where derivatives of an assumption are too large nothing is decided") {
  const std::string notes = scalars + rigor_says("scalar c, q, e, f, g, h") +
                            rigor_says("variable a, b, c, q, e, f, g, h, x") +
                            rigor_says("given abcqefgh x = 1");
  CHECK(with(notes, "\\frac{d^9}{dt^9}\\frac{d^9}{dt^9}x = 0").starts_with("undecided"));
}
