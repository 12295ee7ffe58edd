// SPDX-License-Identifier: GPL-3.0-or-later
// Both sides of an equation: rank, free indices, zeros, and what a reading rests on.
#include "elaborate/notation/elaborate.h"

#include "catch.h"
#include "elaborate/elaborated.h"

using namespace rigor;

TEST_CASE("the sides of an equation share their free indices") {
  CHECK(meaning("(\\mathbf{A}\\times\\mathbf{B})_i = \\epsilon_{ijk}A_jB_k") ==
        "(component[i] (cross \\mathbf{A} \\mathbf{B})) = "
        "(index-sum j (index-sum k (multiply epsilon[i,j,k] \\mathbf{A}[j] \\mathbf{B}[k])))");
  CHECK(meaning("A_iB_j = A_iB_j") == "(multiply A[i] B[j]) = (multiply A[i] B[j])");
  CHECK(meaning("A_iB_i = A_jB_j") ==
        "(index-sum i (multiply A[i] B[i])) = (index-sum j (multiply A[j] B[j]))");
}

TEST_CASE("a free index on one side only is reported at that index") {
  CHECK(meaning("\\epsilon_{ijk}A_j = B_i").starts_with("13 free-index-mismatch"));
  CHECK(meaning("\\delta_{ij}A_j = B_j").starts_with("20 free-index-mismatch"));
  CHECK(meaning("\\delta_{ij}A_j = 1").starts_with("9 free-index-mismatch"));
  CHECK(meaning("\\delta_{ij}A_j = A_i") == "(index-sum j (multiply delta[i,j] A[j])) = A[i]");
}

TEST_CASE("where nothing shows index notation a letter on one side only can be a label") {
  CHECK(meaning("v_i = v_0").starts_with("3 ambiguous-reading"));
  CHECK(meaning("A_i = B").starts_with("3 ambiguous-reading"));
  CHECK(meaning("A_i = B_j").starts_with("9 ambiguous-reading"));
  CHECK(meaning("A_i = B_i") == "A[i] = B[i]");
}

TEST_CASE("a scalar against a vector is a rank mismatch at the relation") {
  CHECK(meaning("a = \\mathbf{B}").starts_with("3 rank-mismatch"));
  CHECK(meaning("\\mathbf{A}\\cdot\\mathbf{B} = \\mathbf{C}").starts_with("27 rank-mismatch"));
  CHECK(meaning("\\mathbf{A} = B_i").starts_with("12 rank-mismatch"));
  CHECK(meaning("\\mathbf{A}\\mathbf{B} = \\mathbf{C}").starts_with("1 ambiguous-reading"));
}

TEST_CASE("bold letters side by side against a vector can be a matrix and a vector") {
  CHECK(meaning("\\mathbf{A}\\mathbf{B} = \\mathbf{C}").starts_with("1 ambiguous-reading"));
  Statements statements;
  statements.meaning("\\mathbf{A}\\mathbf{B} = \\mathbf{B}\\mathbf{A}");
  CHECK(statements.guess.has_value());
}

TEST_CASE("a written zero fits every side") {
  CHECK(meaning("\\mathbf{A} = 0") == "\\mathbf{A} = 0");
  CHECK(meaning("0 = A_iB_j") == "0 = (multiply A[i] B[j])");
  CHECK(meaning("\\mathbf{A}\\mathbf{B} = \\mathbf{0}") == "(multiply \\mathbf{A} \\mathbf{B}) = 0");
}

TEST_CASE("a zero becomes the zero of what it is compared with") {
  Stretch stretch("0 \\mathbf{A}\\mathbf{B}");
  SyntaxTree syntax;
  Statements file;
  Diagnostics diagnostics;
  const TokenView tokens = stretch.tokens;
  const SyntaxId left = parse_side(tokens.first(1), {}, syntax);
  const SyntaxId right = parse_side(tokens.subspan(1), {}, syntax);
  Reading reading{syntax, file.tree, file.names, {}, diagnostics};
  const auto zero = elaborate(reading, left);
  const auto dyad = elaborate(reading, right);
  REQUIRE((zero && dyad));
  const auto equation = equate(reading, *zero, *dyad, {{}, diagnostics});
  REQUIRE(equation.has_value());
  CHECK(dump(file.tree, equation->left) == "(tuple (tuple 0 0 0) (tuple 0 0 0) (tuple 0 0 0))");
  CHECK(is_literal_zero(file.tree, *zero));
  CHECK_FALSE(is_literal_zero(file.tree, *dyad));
}

TEST_CASE("a side that is the same for every particle stands against one that is not") {
  Statements statements;
  statements.beside("\\sum_\\alpha m_\\alpha").beside("\\sum_\\beta m_\\beta");
  CHECK(statements.meaning("m_\\alpha = M") == "m{\\alpha} = M");
  CHECK(statements.meaning("m_\\alpha = k_\\alpha") == "m{\\alpha} = k{\\alpha}");
}

TEST_CASE("what is not read says why at its place, and the other side is read") {
  CHECK(meaning("\\mathbf{A} = \\foo{\\mathbf{B}}") == "14 unsupported: \\mathbf{A} = ?");
  CHECK(meaning("\\text{torque} = \\mathbf{B}") == "1 passed-over: ? = \\mathbf{B}");
  CHECK(meaning("a = (b") == "5 unbalanced: a = ?");
}

TEST_CASE("numbers are kept as written") {
  CHECK(meaning("0.5a") == "(multiply 0.5 a)");
  CHECK(meaning(std::string(300, '7')) == std::string(300, '7'));
  CHECK(meaning(std::string(301, '7')) == "1 unsupported: ?");
}

TEST_CASE("the union of free letters has each letter once") {
  std::vector<FreeIndex> into{{"i", IndexId{0}, {}}};
  merge_free(into, {{"j", IndexId{1}, {}}, {"i", IndexId{0}, {}}});
  REQUIRE(into.size() == 2);
  CHECK(into[1].letter == "j");
}
