// SPDX-License-Identifier: GPL-3.0-or-later
// Dimensions of whole notes: what is found, and what is said where two places disagree.
#include "check/dimension/dimensions.h"

#include "catch.h"
#include "check/checked.h"

namespace rigor {
namespace {

std::string display(const std::string& statement) { return "$$" + statement + "$$\n\n"; }

/// `x: L, v: free`, the time first, the others in the order of first mention.
std::string table_of(const std::string& notes) {
  const Checked checked(notes);
  std::string text;
  for (const SymbolDimension& entry : checked.report.dimensions)
    text += (text.empty() ? "" : ", ") + entry.symbol + ": " + entry.dimension.value_or("free");
  return text;
}

/// The messages about dimensions, one a line.
std::string said_of(const std::string& notes) {
  const Checked checked(notes);
  std::string text;
  const auto add = [&](const Diagnostics& diagnostics) {
    for (const Diagnostic& each : diagnostics) {
      if (info(each.kind).name.starts_with("dimension-")) text += each.message + "\n";
    }
  };
  for (const Step& step : checked.report.steps) add(step.diagnostics);
  add(checked.report.diagnostics);
  return text;
}

const std::string units = rigor_says("units x: L, t: T, m: M");

TEST_CASE("dimensions follow from definitions, laws and assumptions") {
  CHECK(table_of(units + display("v = \\dot x") + display("F = m\\ddot x") + display("P = Fv")) ==
        "t: T, x: L, m: M, v: L T^{-1}, F: M L T^{-2}, P: M L^2 T^{-3}");
  CHECK(table_of(units + rigor_says("given F = m\\ddot x") + display("W = Fx")) ==
        "t: T, x: L, m: M, F: M L T^{-2}, W: M L^2 T^{-2}");
}

TEST_CASE("t is the time, where nothing else is said of it") {
  CHECK(table_of(rigor_says("units x: L") + display("v = \\dot x")) == "t: T, x: L, v: L T^{-1}");
  CHECK(table_of(rigor_says("units x: L, t: L") + display("v = \\dot x")) == "t: L, x: L, v: 1");
  CHECK(table_of(rigor_says("units x: L, v: 1") + display("x = vt")) == "t: L, x: L, v: 1");
}

TEST_CASE("a number alone settles nothing, and is doubted where a quantity is known") {
  const std::string numbers = display("v = 2, \\qquad x = 5") + rigor_says("given x = vt");
  CHECK(said_of(numbers).empty());
  CHECK(said_of(rigor_says("units t: T") + numbers).empty());
  CHECK(said_of(rigor_says("units v: L/T") + numbers) ==
        "a number is where a quantity of dimension L T^{-1} is expected\n");
  CHECK(said_of(rigor_says("units \\mathbf{r}: L") + display("\\mathbf{r} = (1, 2, 3)")) ==
        "a number is where a quantity of dimension L is expected\n");
  CHECK(said_of(rigor_says("units x: L, t: T") + rigor_says("where k = 2") + rigor_says("claim x = kt"))
            .empty());
  CHECK(table_of(rigor_says("units t: T") + display("n = 3, \\qquad s = nt")) == "t: T, n: 1, s: T");
}

TEST_CASE("what nothing settles is free") {
  CHECK(table_of(units + display("x = vt + ab")) == "t: T, x: L, m: M, v: L T^{-1}, a: free, b: free");
}

TEST_CASE("a dimension is found by a later line as well") {
  CHECK(table_of(display("x = vt") + units) == "t: T, x: L, v: L T^{-1}, m: M");
}

TEST_CASE("sides, terms, arguments and components have one dimension") {
  CHECK(said_of(units + display("x^2 = 2tx")) ==
        "the sides have different dimensions: left is L^2, right is L T\n");
  CHECK(said_of(units + display("y = x + t")) == "terms of a sum have different dimensions: L and T\n");
  CHECK(said_of(units + display("y = \\sin x")) == "the argument of a function has the dimension L\n");
  CHECK(said_of(units + display("\\mathbf{r} = (x, t, 0)")) ==
        "components have different dimensions: L and T\n");
  CHECK(said_of(units + display("\\mathbf{r} = (x, 2x, 0)")).empty());
}

TEST_CASE("a symbol with two dimensions names the earlier line") {
  const Checked checked(units + display("v = \\dot x") + display("v = xt"));
  CHECK(said_of(units + display("v = \\dot x") + display("2v = mv")) ==
        "the sides have different dimensions: left is L T^{-1}, right is M L T^{-1}\n");
  const Diagnostics& diagnostics = checked.report.steps.at(1).diagnostics;
  const Diagnostic& clash = diagnostics.back();
  CHECK(clash.message == "`v` has the dimension L T^{-1} by line 2, and L T here");
  CHECK(checked.sources.text(clash.labels.back().span) == "v = \\dot x");
}

TEST_CASE("what contradicts is no source") {
  CHECK(said_of(units + display("v = \\dot x") + display("v = xt") + display("a = vt + x")).find("line 4") ==
        std::string::npos);
}

TEST_CASE("a refuted step is no source, and an expected refutation is not spoken of") {
  const std::string wrong = display("(x + q)^2 = x^2 + q^3");
  CHECK(table_of(units + wrong) == "t: T, x: L, m: M, q: free");
  CHECK_FALSE(said_of(units + rigor_says("units q: L") + wrong).empty());
  CHECK(said_of(units + rigor_says("units q: L") + rigor_says("expect refuted") + wrong).empty());
}

TEST_CASE("the letters of an identity or of a claim bind nothing else") {
  const std::string identity = display("(a + b)^2 = a^2 + 2ab + b^2");
  CHECK(said_of(rigor_says("units t: T") + identity + display("x = a + bt")).empty());
  const std::string claims = rigor_says("scalar a, b, k") + rigor_says("units t: T") +
                             rigor_says("where k = a - b") + rigor_says("claim k + b = a") +
                             rigor_says("where a = bt") + rigor_says("claim a/b = t");
  CHECK(said_of(claims).empty());
}

TEST_CASE("a second definition and a later units line are of another quantity") {
  CHECK(said_of(units + display("v = \\dot x") + rigor_says("let v = mx") + display("E = mv")).empty());
  CHECK(said_of("# A\n" + units + display("y = x") + "# B\n" + rigor_says("units x: T") + display("z = x"))
            .empty());
  CHECK(said_of(rigor_says("units x: L") + rigor_says("units x: T") + display("y = x")) ==
        "`x` has the dimension L by line 1, and T here\n");
}

TEST_CASE("the angular velocity of a frame is so much a time") {
  CHECK(table_of(rigor_says("units t: T") + rigor_says("frame rot rotates with \\boldsymbol{\\omega} in in") +
                 display("\\mathbf{L} = I\\boldsymbol{\\omega}"))
            .find("\\boldsymbol{\\omega}: T^{-1}") != std::string::npos);
}

TEST_CASE("rows and columns of a determinant may differ, entries of them may not") {
  const std::string declared = rigor_says("units a: L, b: T");
  const auto determinant = [](const std::string& rows) {
    return display("d = \\begin{vmatrix} " + rows + " \\end{vmatrix}");
  };
  CHECK(said_of(declared + determinant("a & b & a \\\\ a & b & a \\\\ 1 & b/a & 1")).empty());
  CHECK_FALSE(said_of(declared + determinant("a & b & a \\\\ a & a & a \\\\ 1 & b/a & 1")).empty());
}

TEST_CASE("coordinates have the dimension of what is differentiated by") {
  CHECK(said_of(rigor_says("units \\mathbf{r}: L, \\phi: L^2") + display("\\mathbf{g} = \\nabla\\phi") +
                display("\\mathbf{g} = 2\\mathbf{r}")) == "");
  CHECK_FALSE(said_of(rigor_says("units x: L, f: T, h: T") + display("h = x\\,\\partial_x f") +
                      display("k = h + x^2\\,\\partial_x f"))
                  .empty());
}

TEST_CASE("an integral over the body has the dimension of a sum, and the density of mass by volume") {
  const std::string notes =
      rigor_says("units m_\\alpha: M, \\mathbf{r}_\\alpha: L") + display("M = \\int \\rho\\,dV") +
      display("J = \\int \\rho\\,|\\mathbf{r}|^2\\,dV") + display("C = \\sum_\\alpha m_\\alpha r_\\alpha");
  const std::string table = table_of(notes);
  CHECK(table.find("M: M, ") != std::string::npos);
  CHECK(table.find("J: M L^2") != std::string::npos);
  CHECK(table.find("\\rho_\\alpha: M L^{-3}") != std::string::npos);
}

TEST_CASE("without units, two lines that make a number of the time are doubted, one line is not") {
  CHECK(said_of(display("x = vt") + display("2x = vt^2")) ==
        "the sides have different dimensions: left is [x], right is T [x], unless the time is a number\n");
  CHECK(said_of(display("x = t + t^2") + display("x = vt") + display("2x = vt^2")).empty());
  CHECK(said_of(display("x = vt") + display("y = \\beta z") + display("\\beta = x/z")).empty());
}

}  // namespace
}  // namespace rigor
