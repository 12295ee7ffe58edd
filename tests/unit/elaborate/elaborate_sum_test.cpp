// SPDX-License-Identifier: GPL-3.0-or-later
// Sums of terms, and sums over an index or over particles.
#include "catch.h"
#include "elaborate/elaborated.h"

using namespace rigor;

TEST_CASE("the terms of a sum keep their order and signs") {
  CHECK(meaning("-\\mathbf{A} + \\mathbf{B} - \\mathbf{C}") ==
        "(add (negate \\mathbf{A}) \\mathbf{B} (negate \\mathbf{C}))");
  CHECK(meaning("-A_iB_i") == "(negate (index-sum i (multiply A[i] B[i])))");
}

TEST_CASE("a zero in a sum fits every term") {
  CHECK(meaning("\\mathbf{A} + 0") == "\\mathbf{A}");
  CHECK(meaning("0 - A_i") == "(negate A[i])");
  CHECK(meaning("0 + 0") == "0");
}

TEST_CASE("a dummy of one term is free to be used in another") {
  CHECK(meaning("A_iB_i + C_iD_i") ==
        "(add (index-sum i (multiply A[i] B[i])) (index-sum i (multiply C[i] D[i])))");
  CHECK(meaning("A_iB_jB_j + A_j A_j B_i") ==
        "(add (index-sum j (multiply A[i] B[j] B[j])) (index-sum j (multiply A[j] A[j] B[i])))");
}

TEST_CASE("a scalar beside a vector is a rank mismatch at the term that differs from the first") {
  CHECK(meaning("\\mathbf{A} + b") == "14 rank-mismatch: ?");
  CHECK(meaning("a + \\mathbf{B}") == "5 rank-mismatch: ?");
  CHECK(meaning("A_i + \\mathbf{B}") == "7 rank-mismatch: ?");
  CHECK(meaning("\\mathbf{A} + \\mathbf{A}\\mathbf{B}") == "14 ambiguous-reading: ?");
}

TEST_CASE("a free index in one term only is reported at that index") {
  Statements vectors;
  vectors.declare({"A", 1, false}).declare({"B", 1, false});
  CHECK(vectors.meaning("\\partial_iA_j + \\partial_jB_k") == "29 free-index-mismatch: ?");
  CHECK(meaning("A_iA_iA_j + B") == "9 free-index-mismatch: ?");
  CHECK(meaning("\\delta_{ij} + C_i") == "10 free-index-mismatch: ?");
  CHECK(meaning("A_iB_j + A_jB_i") == "(add (multiply A[i] B[j]) (multiply A[j] B[i]))");
}

TEST_CASE("a letter that only the letter it stands on makes an index can be a label") {
  CHECK(meaning("A_i + B_j") == "9 ambiguous-reading: ?");
  CHECK(meaning("A_i + B") == "3 ambiguous-reading: ?");
  Statements vectors;
  vectors.names.symbols.evidence.write().vectors = {"A", "B"};
  CHECK(vectors.meaning("A_i + B_j") == "9 free-index-mismatch: ?");
  Statements tensor;
  tensor.declare({"S", 2, false});
  CHECK(tensor.meaning("S_{ij}c_j + d") == "4 free-index-mismatch: ?");
}

TEST_CASE("every part that is not understood is reported") {
  CHECK(meaning("\\mathbf{A}\\otimes\\mathbf{B} + \\foo") == "11 unsupported, 31 unsupported: ?");
  CHECK(meaning("\\foo\\max y") == "1 unsupported, 5 unsupported: ?");
}

TEST_CASE("a sum over a letter runs over the axes") {
  CHECK(meaning("\\sum_i A_iB_i") == "(index-sum i (multiply A[i] B[i]))");
  CHECK(meaning("\\sum_{i=1}^3 A_iB_j") == "(index-sum i (multiply A[i] B[j]))");
  CHECK(meaning("\\sum_{i,j} I_{ij}\\omega_i\\omega_j") ==
        "(index-sum i (index-sum j (multiply I[i,j] \\omega[i] \\omega[j])))");
  CHECK(meaning("\\sum_a A_aB_a") == "(index-sum a (multiply A[a] B[a]))");
}

TEST_CASE("under a written sum an index may occur as often as it likes") {
  CHECK(meaning("\\sum_i A_iB_iC_i") == "(index-sum i (multiply A[i] B[i] C[i]))");
  CHECK(meaning("\\sum_i A_i^2") == "(index-sum i (power A[i] 2))");
}

TEST_CASE("a sum ends with its term") {
  CHECK(meaning("\\sum_i A_i + B_i") == "16 ambiguous-reading: ?");
  CHECK(meaning("\\sum_i (A_i + B_i)") == "(index-sum i (add A[i] B[i]))");
}

TEST_CASE("a sum that does not run from 1 to 3 is over whole numbers, and a symbol of its own") {
  CHECK(meaning("\\sum_{i=1}^N A_i") == "\\sum_{i=1}^{N} A_i");
  CHECK(meaning("\\sum_{i=0}^3 A_i") == "\\sum_{i=0}^{3} A_i");
  CHECK(meaning("\\sum_{k=1}^3 k") == "\\sum_{k=1}^{3} k");
  CHECK(meaning("\\sum_{i=1}^N A_{ij}") == "7 unsupported: ?");
  CHECK(meaning("\\sum_{i'} A_{i'}") == "7 unsupported: ?");
}

TEST_CASE("a sum over a Greek letter or a declared one runs over particles") {
  CHECK(meaning("\\sum_\\alpha m_\\alpha\\mathbf{r}_\\alpha") ==
        "(particle-sum \\alpha (multiply m{\\alpha} \\mathbf{r}{\\alpha}))");
  CHECK(meaning("\\sum_{\\alpha=1}^N m_\\alpha") == "(particle-sum \\alpha m{\\alpha})");
  CHECK(Statements().particles("a").meaning("\\sum_a \\mathbf{r}_a\\times\\mathbf{v}_a") ==
        "(particle-sum a (cross \\mathbf{r}{a} \\mathbf{v}{a}))");
  CHECK(Statements().particles("i").meaning("\\sum_i m_i\\mathbf{r}_i") ==
        "(particle-sum i (multiply m{i} \\mathbf{r}{i}))");
}

TEST_CASE("a sum over particles holds components, lengths and dot products of each") {
  CHECK(meaning("\\sum_\\alpha m_\\alpha r_{\\alpha i}r_{\\alpha j}") ==
        "(particle-sum \\alpha (multiply m{\\alpha} r{\\alpha}[i] r{\\alpha}[j]))");
  CHECK(meaning("\\sum_\\alpha m_\\alpha(r_\\alpha^2 + \\mathbf{r}_\\alpha\\cdot\\mathbf{R})") ==
        "(particle-sum \\alpha (multiply m{\\alpha} (add (power (length \\mathbf{r}{\\alpha}) 2) "
        "(dot \\mathbf{r}{\\alpha} \\mathbf{R}))))");
}

TEST_CASE("sums over two particles nest") {
  CHECK(meaning("\\sum_\\alpha\\sum_\\beta m_\\alpha m_\\beta") ==
        "(particle-sum \\alpha (particle-sum \\beta (multiply m{\\alpha} m{\\beta})))");
}

TEST_CASE("a sum over a letter inside a sum over it binds its own") {
  CHECK(meaning("\\sum_i A_i\\sum_i B_i") == "(index-sum i (multiply A[i] (index-sum i B[i])))");
  CHECK(meaning("(\\sum_i A_i)(\\sum_i B_i)") == "(multiply (index-sum i A[i]) (index-sum i B[i]))");
}

TEST_CASE("a term that is the same for every particle stands beside one that is not") {
  CHECK(meaning("\\sum_\\alpha m_\\alpha + m_\\alpha") ==
        "(add (particle-sum \\alpha m{\\alpha}) m{\\alpha})");
}
