// SPDX-License-Identifier: GPL-3.0-or-later
// Powers, roots, bars, components, tuples, matrices and determinants.
#include "catch.h"
#include "elaborate/elaborated.h"

using namespace rigor;

TEST_CASE("whole and half exponents are powers and roots") {
  CHECK(meaning("a^2") == "(power a 2)");
  CHECK(meaning("a^{-1}") == "(power a -1)");
  CHECK(meaning("(a)^1") == "a");
  CHECK(meaning("a^{1/2}") == "(root a)");
  CHECK(meaning("a^{-\\frac12}") == "(power (root a) -1)");
  CHECK(meaning("a^{3/2}") == "(power (root a) 3)");
}

TEST_CASE("a letter that may be an index is no exponent, any other number is") {
  CHECK(meaning("a^n") == "3 unsupported: ?");
  CHECK(meaning("a^{1/3}") == "(real-power a (divide 1 3))");
  CHECK(meaning("a^{b - 1}") == "(real-power a (add b (negate 1)))");
  CHECK(meaning("a^{64}") == "(power a 64)");
  CHECK(meaning("a^{65}") == "(real-power a 65)");
}

TEST_CASE("the square of a vector is its dot product with itself, an odd power is not read") {
  CHECK(meaning("\\mathbf{A}^2") == "(dot \\mathbf{A} \\mathbf{A})");
  CHECK(meaning("(\\mathbf{A}\\times\\mathbf{B})^2") ==
        "(dot (cross \\mathbf{A} \\mathbf{B}) (cross \\mathbf{A} \\mathbf{B}))");
  CHECK(meaning("\\mathbf{A}^4") == "(power (length \\mathbf{A}) 4)");
  CHECK(meaning("b\\,\\mathbf{A}^3") == "4 unsupported: ?");
  CHECK(meaning("\\overleftrightarrow{I}^2") == "1 unsupported: ?");
}

TEST_CASE("a component with an axis has powers, one with a free index can be summed or not") {
  CHECK(meaning("A_1^2\\mathbf{A}") == "(multiply (power \\mathbf{A}[1] 2) \\mathbf{A})");
  CHECK(meaning("(A_iB_i)^2") == "(power (index-sum i (multiply A[i] B[i])) 2)");
  CHECK(meaning("A_i^2") == "1 ambiguous-reading: ?");
  CHECK(meaning("(A_i)^1") == "A[i]");
}

TEST_CASE("bars are a length around a vector and an absolute value around a scalar") {
  CHECK(meaning("|\\mathbf{A}|") == "(length \\mathbf{A})");
  CHECK(meaning("\\left|\\mathbf{A}\\times\\mathbf{B}\\right|^2") ==
        "(power (length (cross \\mathbf{A} \\mathbf{B})) 2)");
  CHECK(meaning("|\\mathbf{A}||\\mathbf{B}|") == "(multiply (length \\mathbf{A}) (length \\mathbf{B}))");
  CHECK(meaning("|a|") == "(absolute a)");
  CHECK(meaning("|A_iB_i|") == "(absolute (index-sum i (multiply A[i] B[i])))");
}

TEST_CASE("double bars are for vectors only") {
  CHECK(meaning("\\|\\mathbf{A}-\\mathbf{B}\\|") == "(length (add \\mathbf{A} (negate \\mathbf{B})))");
  CHECK(meaning("\\|a\\|") == "1 rank-mismatch: ?");
}

TEST_CASE("bars around a tensor are its determinant") {
  const std::string rows = "I[1,1] I[1,2] I[1,3] I[2,1] I[2,2] I[2,3] I[3,1] I[3,2] I[3,3]";
  CHECK(meaning("|\\overleftrightarrow{\\mathbf I}|").starts_with("(determinant "));
  CHECK(meaning("|I_{ij}|") == "(determinant " + rows + ")");
}

TEST_CASE("a root is of a scalar") {
  CHECK(meaning("\\sqrt{A_iA_i}") == "(root (index-sum i (multiply A[i] A[i])))");
  CHECK(meaning("\\sqrt{\\mathbf{A}}") == "1 rank-mismatch: ?");
  CHECK(meaning("\\sqrt{A_i}") == "1 unsupported: ?");
}

TEST_CASE("an index on a bracket picks the component of what is inside") {
  CHECK(meaning("(\\mathbf{A}\\times\\mathbf{B})_i") == "(component[i] (cross \\mathbf{A} \\mathbf{B}))");
  CHECK(meaning("(\\mathbf{A}+\\mathbf{B})_z") == "(component[3] (add \\mathbf{A} \\mathbf{B}))");
  CHECK(meaning("(\\mathbf{A}\\mathbf{B})_{ij}") == "(component[i,j] (multiply \\mathbf{A} \\mathbf{B}))");
  CHECK(meaning("(\\mathbf{A}\\times\\mathbf{B})_iC_i") ==
        "(index-sum i (multiply (component[i] (cross \\mathbf{A} \\mathbf{B})) C[i]))");
  CHECK(meaning("(\\mathbf{A}\\mathbf{B})_{ii}") ==
        "(index-sum i (component[i,i] (multiply \\mathbf{A} \\mathbf{B})))");
}

TEST_CASE("a bracket has as many indices as axes") {
  CHECK(meaning("b(\\mathbf{A}\\times\\mathbf{B})_{ij}") == "2 rank-mismatch: ?");
  CHECK(meaning("(\\mathbf{A}\\cdot\\mathbf{B})_i") == "1 rank-mismatch: ?");
  CHECK(meaning("(\\mathbf{A}+\\mathbf{B})_{\\text{rot}}") == "26 unsupported: ?");
  CHECK(meaning("(\\mathbf{A})_{i'}") == "1 ambiguous-reading: ?");
}

TEST_CASE("three scalars in brackets are a vector") {
  CHECK(meaning("(a,b,c)") == "(tuple a b c)");
  CHECK(meaning("\\begin{pmatrix}a\\\\b\\\\c\\end{pmatrix} + \\mathbf{A}") ==
        "(add (tuple a b c) \\mathbf{A})");
  CHECK(meaning("(a,b)") == "1 unsupported: ?");
  CHECK(meaning("(a,\\mathbf{b},c)") == "4 unsupported: ?");
}

TEST_CASE("three rows of three scalars are a tensor") {
  CHECK(meaning("\\begin{pmatrix}1&0&0\\\\0&a&0\\\\0&0&1\\end{pmatrix}") ==
        "(tuple (tuple 1 0 0) (tuple 0 a 0) (tuple 0 0 1))");
  CHECK(meaning("2\\begin{pmatrix}1&0\\\\0&1\\end{pmatrix}") ==
        "(multiply 2 (tuple (tuple 1 0) (tuple 0 1)))");
}

TEST_CASE("factors in rows and columns are multiplied as matrices") {
  CHECK(meaning("\\begin{pmatrix}a&b\\\\c&f\\end{pmatrix}\\begin{pmatrix}1\\\\2\\end{pmatrix}") ==
        "(dot (tuple (tuple a b) (tuple c f)) (tuple 1 2))");
  CHECK(meaning("\\begin{pmatrix}a&b\\end{pmatrix}\\begin{pmatrix}1\\\\2\\end{pmatrix}") ==
        "(dot (tuple a b) (tuple 1 2))");
  CHECK(meaning("\\begin{pmatrix}1\\\\2\\end{pmatrix}\\begin{pmatrix}a&b\\end{pmatrix}") ==
        "(multiply (tuple 1 2) (tuple a b))");
  CHECK(meaning("\\begin{pmatrix}a&b\\\\c&f\\end{pmatrix}^T") == "(tuple (tuple a c) (tuple b f))");
  CHECK(meaning("\\begin{pmatrix}1\\\\2\\end{pmatrix}\\begin{pmatrix}a\\\\b\\end{pmatrix}")
            .ends_with("unsupported: ?"));
  CHECK(meaning("\\begin{pmatrix}a&b\\\\c&f\\end{pmatrix}\\begin{pmatrix}1\\\\2\\\\3\\end{pmatrix}")
            .ends_with("unsupported: ?"));
  CHECK(meaning("Q\\begin{pmatrix}1\\\\2\\end{pmatrix}").ends_with("ambiguous-reading: ?"));
  CHECK(meaning("\\begin{pmatrix}n\\\\k\\end{pmatrix}").ends_with("ambiguous-reading: ?"));
  CHECK(meaning("\\begin{pmatrix}1&2&3\\\\2&3&1\\end{pmatrix}").ends_with("ambiguous-reading: ?"));
}

TEST_CASE("a determinant has scalars, or vectors in its first row") {
  CHECK(meaning("\\begin{vmatrix}\\hat{x}&\\hat{y}&\\hat{z}\\\\a&b&c\\\\d&f&g\\end{vmatrix}") ==
        "(determinant e[1] e[2] e[3] a b c d f g)");
  CHECK(meaning("\\begin{vmatrix}1&2&3\\\\4&5&6\\\\7&8&9\\end{vmatrix}") ==
        "(determinant 1 2 3 4 5 6 7 8 9)");
  CHECK(meaning("\\begin{vmatrix}a&\\mathbf{b}&c\\\\1&2&3\\\\4&5&6\\end{vmatrix}") == "1 rank-mismatch: ?");
  CHECK(meaning("\\begin{vmatrix}a&b\\\\c&d\\end{vmatrix}") ==
        "(add (multiply a d) (negate (multiply b c)))");
  CHECK(meaning("\\begin{vmatrix}a&b&c\\\\d&e&f\\end{vmatrix}") == "1 unsupported: ?");
}
