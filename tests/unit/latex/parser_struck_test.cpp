// SPDX-License-Identifier: GPL-3.0-or-later
// What is struck out, and brackets of states and of operators.
#include "catch.h"
#include "latex/dump_syntax.h"

namespace {

using namespace rigor;

struct Read {
  Stretch stretch;
  SyntaxTree tree;
  SyntaxId root{};

  explicit Read(const std::string& text) : stretch(text) {
    const Tokens side = stretch.side();
    root = parse_side(side, span_of(side), tree);
  }
  [[nodiscard]] std::string dump() const { return dump_syntax(tree, root); }
};

std::string parsed(const std::string& text) { return Read(text).dump(); }

/// All obstacles in the text.
std::string obstacles(const std::string& text) {
  const Read read(text);
  std::string all;
  for (const SyntaxId id : nodes_below(read.tree, {read.root})) {
    if (read.tree[id].kind == SyntaxKind::opaque) all += read.tree.obstacle(id).message + "; ";
  }
  return all;
}

}  // namespace

TEST_CASE("what cancels above and below, or in a sum, is read as if it were not struck out") {
  for (const char* text :
       {"\\frac{\\cancel{x}y}{\\cancel{x}}", "\\cancel{x}y/\\bcancel{x}", "\\xcancel{x} + y - \\cancel{x}",
        "\\frac{\\cancel{4}y}{\\cancel{2}}", "\\cancel{(a + b)}y"}) {
    INFO(text);
    CHECK(obstacles(text).find("struck out, and may be 0") !=
          std::string::npos);  // beside it, so that it is not refuted
  }
}

TEST_CASE("a struck term alone, a struck letter alone and a value at its arrow are not read") {
  CHECK(obstacles("y + \\cancel{2ab}").find("why `\\cancel{2ab}` is struck out") != std::string::npos);
  CHECK(obstacles("\\cancel{2ab} + y + \\cancel{2ab}").find("why") != std::string::npos);
  CHECK(obstacles("\\frac{\\cancel{p} + m}{2}").find("Dirac") != std::string::npos);
  CHECK(obstacles("i\\cancel{\\partial}").find("Dirac") != std::string::npos);
  CHECK(obstacles("\\cancelto{0}{x} + y").find("that `x` becomes `0`") != std::string::npos);
  CHECK(obstacles("\\frac{\\cancel{4}^2}{\\cancel{2}}").find("take its place") != std::string::npos);
}

TEST_CASE("a bracket of states is a bra and a ket, however it is written") {
  for (const char* text : {"\\braket{a|b}", "\\braket{a}{b}", "\\ip{a}{b}", "\\langle a | b \\rangle",
                           "\\left\\langle a\\middle|b\\right\\rangle"}) {
    INFO(text);
    CHECK(parsed(text) == parsed("\\langle a|b\\rangle"));
  }
  for (const char* text : {"\\Braket{a|H|b}", "\\mel**{a}{H}{b}", "\\matrixel{a}{H}{b}"}) {
    INFO(text);
    CHECK(parsed(text) == parsed("\\langle a|H|b\\rangle"));
  }
  CHECK(parsed("\\ev{A}{a}") == parsed("\\langle a|A|a\\rangle"));
  CHECK(parsed("\\ketbra{a}{b}") == parsed("\\dyad{a}{b}"));
  CHECK(obstacles("\\ket\\psi + \\ket{n + 1} - |{\\uparrow}\\rangle").empty());
  CHECK(obstacles("|\\langle a|b\\rangle|^2 + |c|").empty());
}

TEST_CASE("a ket with a sum or an operator in it is not read, nor is a bracket with two bars in a row") {
  CHECK(obstacles("|\\psi + \\phi\\rangle").find("sum") != std::string::npos);
  CHECK(obstacles("|A\\psi\\rangle").find("acts on a state") != std::string::npos);
  CHECK(!obstacles("\\langle j||T||k\\rangle").empty());
}

TEST_CASE("angle brackets without bars or commas are an average, however they are written") {
  for (const char* text : {"\\left\\langle x^2\\right\\rangle", "\\ev{x^2}", "\\expval*{x^2}",
                           "\\Braket{x^2}", "\\mathbb E[x^2]", "\\operatorname{E}(x^2)"}) {
    INFO(text);
    CHECK(parsed(text) == parsed("\\langle x^2\\rangle"));
  }
  CHECK(parsed("\\operatorname{Var}(x)") == parsed("\\langle(x - \\langle x\\rangle)^2\\rangle"));
  CHECK(parsed("\\mathrm{Cov}(x, y)") ==
        parsed("\\langle(x - \\langle x\\rangle)(y - \\langle y\\rangle)\\rangle"));
  CHECK(obstacles("\\langle|x|\\rangle + \\langle\\langle x\\rangle y\\rangle^2").empty());
}

TEST_CASE(
    "an average with a subscript, a pair in angle brackets and a conditional expectation are not read") {
  CHECK(obstacles("\\langle x\\rangle_T").find("subscript") != std::string::npos);
  CHECK(obstacles("\\langle x\\rangle^2_T").find("subscript") != std::string::npos);
  CHECK(obstacles("\\langle u, v\\rangle").find("inner product") != std::string::npos);
  CHECK(!obstacles("\\mathbb E[x|y]").empty());
  CHECK(!obstacles("\\braket{x}").empty());
}

TEST_CASE("a commutator is the pair that it abbreviates, and a Poisson bracket a pair of numbers") {
  CHECK(parsed("\\comm{A}{B}") == parsed("[A, B]"));
  CHECK(parsed("\\commutator*{A}{B + C}") == parsed("[A, B + C]"));
  CHECK(parsed("\\acomm{A}{B}") == parsed("\\{A, B\\}"));
  CHECK(parsed("\\pb{q}{p}") == parsed("(q, p)"));
}
