// SPDX-License-Identifier: GPL-3.0-or-later
// How expressions look; that they read back, other tests say.
#include "expr/print/print_latex.h"

#include "catch.h"
#include "elaborate/elaborated.h"
#include "expr/tree/same_expression.h"

namespace rigor {
namespace {

/// Reads and prints.
std::string printed(Statements& page, const std::string& latex, const Notation& notation = {}) {
  std::string complaint;
  const auto read = page.read(latex, complaint);
  return read ? print_latex(page.tree, *read, notation) : complaint;
}

Statements vectors() {
  Statements page;
  for (const char* name : {"A", "B", "C"})
    page.declare({name, 1, false}, {.name = "\\mathbf{" + std::string(name) + "}"});
  return page;
}

}  // namespace

TEST_CASE("brackets stand where they are needed and nowhere else") {
  Statements page = vectors();
  CHECK(printed(page, "(\\mathbf{A}) \\cdot((\\mathbf{B}))") == "\\mathbf{A}\\cdot\\mathbf{B}");
  CHECK(printed(page, "\\mathbf{A}\\times(\\mathbf{B}\\times\\mathbf{C})") ==
        "\\mathbf{A}\\times(\\mathbf{B}\\times\\mathbf{C})");
  CHECK(printed(page, "(\\mathbf{A}\\cdot\\mathbf{B})^2 - A^2B^2") ==
        "(\\mathbf{A}\\cdot\\mathbf{B})^2 - A^2 B^2");
  CHECK(printed(page, "a - (b - c)") == "a - (b - c)");
  CHECK(printed(page, "-(-a)") == "-(-a)");
  CHECK(printed(page, "\\left(\\frac{a}{b}\\right)^2") == "\\left(\\frac{a}{b}\\right)^2");
}

TEST_CASE("numbers that stand side by side have a dot between them") {
  Statements page;
  CHECK(printed(page, "2\\cdot 3") == "2\\cdot 3");
  CHECK(printed(page, "2\\cdot\\frac{1}{2}") == "2\\cdot \\frac{1}{2}");
  CHECK(printed(page, "2a") == "2 a");
}

TEST_CASE("a sum over an index has a sign only where the summation convention does not give it") {
  Statements page = vectors();
  CHECK(printed(page, "A_iB_i") == "A_i B_i");
  CHECK(printed(page, "\\sum_i A_iB_i") == "A_i B_i");
  CHECK(printed(page, "\\sum_i A_iB_iC_i") == "\\sum_i A_i B_i C_i");
  CHECK(printed(page, "\\sum_i A_i^2") == "\\sum_i A_i^2");
  CHECK(printed(page, "\\sum_i\\frac{A_iB_i}{c}") == "\\sum_i\\frac{A_i B_i}{c}");
}

TEST_CASE("a bound letter that stands for something else in scope is renamed") {
  Statements page = vectors();
  const IndexId free = page.tree.add_index("i");
  const IndexId bound = page.tree.add_index("i");
  const SymbolId a = *find_symbol(page.names.symbols, {"A", 1, false});
  const SymbolId b = *find_symbol(page.names.symbols, {"B", 1, false});
  const auto at = [&](SymbolId symbol, IndexId index) {
    const Slot slot{0, index};
    return page.tree.add({.op = Op::symbol, .symbol = symbol}, {}, std::span(&slot, 1));
  };
  const ExprId inner[] = {at(a, bound), at(b, bound)};
  const ExprId product = page.tree.add({.op = Op::multiply}, inner);
  const ExprId sum = page.tree.add({.op = Op::index_sum, .index = bound}, std::span(&product, 1));
  const ExprId factors[] = {at(a, free), sum};
  CHECK(print_latex(page.tree, page.tree.add({.op = Op::multiply}, factors)) == "A_i(A_j B_j)");
}

TEST_CASE("the notation of the notes is kept") {
  Statements page = vectors();
  const SymbolId a = *find_symbol(page.names.symbols, {"A", 1, false});
  Notation notation;
  notation.epsilon = "\\epsilon";
  notation.number_fraction = "\\tfrac";
  notation.whole[a] = "\\vec{A}";
  notation.lettered.insert(a);
  CHECK(printed(page, "\\frac12\\mathbf{A}", notation) == "\\tfrac{1}{2}\\,\\vec{A}");
  CHECK(printed(page, "\\varepsilon_{ijk}A_jB_k", notation) == "\\epsilon_{ijk} A_j B_k");
  CHECK(printed(page, "A_1 + A_2", notation) == "A_x + A_y");
}

TEST_CASE("the length of a vector is its plain letter unless that is something else") {
  Statements page = vectors();
  CHECK(printed(page, "|\\mathbf{A}|^2") == "A^2");
  CHECK(printed(page, "|\\mathbf{A} + \\mathbf{B}|") == "|\\mathbf{A} + \\mathbf{B}|");
  page.declare({"A", 0, false});
  CHECK(printed(page, "|\\mathbf{A}|^2") == "|\\mathbf{A}|^2");
}

TEST_CASE("bars in bars say where they open and close") {
  Statements page;
  CHECK(printed(page, "\\lvert a\\lvert b\\rvert\\rvert") == "|a\\lvert b\\rvert|");
}

TEST_CASE("expressions are the same but for the names of bound letters") {
  Statements page = vectors();
  std::string complaint;
  const auto same = [&](const std::string& a, const std::string& b) {
    return same_expression(page.tree, page.read(a, complaint).value(), page.tree,
                           page.read(b, complaint).value());
  };
  CHECK(same("A_iB_i", "A_jB_j"));
  CHECK(same("\\varepsilon_{ijk}A_iB_jC_k", "\\varepsilon_{lmn}A_lB_mC_n"));
  CHECK(!same("\\varepsilon_{ijk}A_iB_jC_k", "\\varepsilon_{ijk}A_jB_iC_k"));
  CHECK(!same("A_iB_i", "B_iA_i"));
  CHECK(!same("a - b", "a + b"));
  CHECK(!same("A_1", "A_2"));
  CHECK(!same("a^2", "a^3"));
}

TEST_CASE("complex numbers: i, stars and parts") {
  Statements page;
  page.names.symbols.evidence.write().imaginary_units = {"i"};
  page.names.symbols.evidence.write().complex_numbers = {"z", "w"};
  CHECK(printed(page, "e^{i\\theta}") == "e^{i\\theta}");
  CHECK(printed(page, "\\bar z w") == "z^* w");
  CHECK(printed(page, "(z + w)^*") == "(z + w)^*");
  CHECK(printed(page, "(z^*)^2") == "(z^*)^2");
  CHECK(printed(page, "(z^2)^*") == "(z^2)^*");
  CHECK(printed(page, "\\Re z") == "\\operatorname{Re}(z)");
  CHECK(printed(page, "(x + iy)^2") == "(x + i y)^2");
}

}  // namespace rigor
