// SPDX-License-Identifier: GPL-3.0-or-later
// Products: precedence, the summation convention, and where a product has two readings.
#include "catch.h"
#include "elaborate/elaborated.h"

using namespace rigor;

TEST_CASE("a cross product binds tighter than a dot product, and that tighter than juxtaposition") {
  CHECK(meaning("\\mathbf{A}\\cdot\\mathbf{B}\\times\\mathbf{C}") ==
        "(dot \\mathbf{A} (cross \\mathbf{B} \\mathbf{C}))");
  CHECK(meaning("\\mathbf{A}\\times\\mathbf{B}\\cdot\\mathbf{C}") ==
        "(dot (cross \\mathbf{A} \\mathbf{B}) \\mathbf{C})");
  CHECK(meaning("\\mathbf{A}\\,\\mathbf{B}\\cdot\\mathbf{C}") ==
        "(multiply \\mathbf{A} (dot \\mathbf{B} \\mathbf{C}))");
  CHECK(meaning("\\mathbf{A}\\cdot\\mathbf{B}\\,\\mathbf{C}\\times\\mathbf{D}") ==
        "(multiply (dot \\mathbf{A} \\mathbf{B}) (cross \\mathbf{C} \\mathbf{D}))");
}

TEST_CASE("brackets come before precedence") {
  CHECK(meaning("(\\mathbf{A}\\times\\mathbf{B})\\times\\mathbf{C}") ==
        "(cross (cross \\mathbf{A} \\mathbf{B}) \\mathbf{C})");
  CHECK(meaning("\\mathbf{A}\\times(\\mathbf{B}\\times\\mathbf{C})") ==
        "(cross \\mathbf{A} (cross \\mathbf{B} \\mathbf{C}))");
  CHECK(meaning("\\mathbf{A}\\times-\\mathbf{B}") == "(cross \\mathbf{A} (negate \\mathbf{B}))");
}

TEST_CASE("two cross products or two dot products in a row have two readings") {
  CHECK(meaning("\\mathbf{A}\\times\\mathbf{B}\\times\\mathbf{C}") == "27 ambiguous-reading: ?");
  CHECK(meaning("\\mathbf{A}\\cdot\\mathbf{B}\\cdot\\mathbf{C}") == "26 ambiguous-reading: ?");
}

TEST_CASE("a tensor between two vectors is contracted with both") {
  CHECK(meaning("\\boldsymbol\\omega\\cdot\\overleftrightarrow{\\mathbf I}\\cdot\\boldsymbol\\omega") ==
        "(dot (dot \\boldsymbol{\\omega} I) \\boldsymbol{\\omega})");
  CHECK(meaning("\\overleftrightarrow{\\mathbf I}\\boldsymbol\\omega") == "31 ambiguous-reading: ?");
  CHECK(meaning("\\overleftrightarrow{\\mathbf I}\\times\\boldsymbol\\omega") == "31 unsupported: ?");
}

TEST_CASE("two vectors side by side are a dyad, three are not read") {
  CHECK(meaning("\\mathbf{A}\\mathbf{B}") == "(multiply \\mathbf{A} \\mathbf{B})");
  CHECK(meaning("\\mathbf{A}\\mathbf{B}\\mathbf{C}") == "21 ambiguous-reading: ?");
}

TEST_CASE("a scalar behind a product sign belongs to the vector behind it") {
  CHECK(meaning("m\\mathbf{R}\\times M\\mathbf{V}") == "(multiply m M (cross \\mathbf{R} \\mathbf{V}))");
  CHECK(meaning("2\\mathbf{A}\\cdot3\\mathbf{B}") == "(multiply 2 3 (dot \\mathbf{A} \\mathbf{B}))");
}

TEST_CASE("a dot between scalars is a product, a cross is only beside a number") {
  CHECK(meaning("a\\cdot b") == "(multiply a b)");
  CHECK(meaning("a\\cdot\\mathbf{B}") == "(multiply a \\mathbf{B})");
  CHECK(meaning("2\\times 3") == "(multiply 2 3)");
  CHECK(meaning("2\\times\\mathbf{V}") == "(multiply 2 \\mathbf{V})");
  CHECK(meaning("a\\times b") == "2 ambiguous-reading: ?");
  CHECK(meaning("m\\times\\mathbf{V}") == "2 rank-mismatch: ?");
  CHECK(meaning("\\mathbf{V}\\times m") == "11 rank-mismatch: ?");
}

TEST_CASE("an index that occurs twice in a term is summed") {
  CHECK(meaning("A_iB_i") == "(index-sum i (multiply A[i] B[i]))");
  CHECK(meaning("A_iB_j") == "(multiply A[i] B[j])");
  CHECK(meaning("\\epsilon_{ijk}A_jB_k") ==
        "(index-sum j (index-sum k (multiply epsilon[i,j,k] A[j] B[k])))");
  CHECK(meaning("A_i\\mathbf{e}_i") == "(index-sum i (multiply A[i] e[i]))");
  CHECK(meaning("A_{ij}B_{jk}") == "(index-sum j (multiply A[i,j] B[j,k]))");
}

TEST_CASE("an index and its partner in a bracket are summed") {
  CHECK(meaning("A_i(B_iC_j)") == "(index-sum i (multiply A[i] (multiply B[i] C[j])))");
  CHECK(meaning("A_i(B_i + C_i)") == "(index-sum i (multiply A[i] (add B[i] C[i])))");
}

TEST_CASE("an index three times in a term is reported at the third") {
  Statements vectors;
  for (const char* letter : {"A", "B", "C", "D"}) vectors.declare({letter, 1, false});
  CHECK(vectors.meaning("A_iB_iC_i") == "9 index-repeats: ?");
  CHECK(vectors.meaning("A_iB_iC_iD_i") == "9 index-repeats: ?");
  CHECK(meaning("\\delta_{ij}A_i\\epsilon_{ijk}") == "25 index-repeats: ?");
  CHECK(meaning("A_iB_i + C_i D_j D_j E_i") ==
        "(add (index-sum i (multiply A[i] B[i])) "
        "(index-sum i (index-sum j (multiply C[i] D[j] D[j] E[i]))))");
}

TEST_CASE("an index three times in a macro is reported at the call") {
  Statements vectors;
  for (const char* letter : {"A", "B", "C"}) vectors.declare({letter, 1, false});
  CHECK(vectors.meaning("\\newcommand{\\w}{A_iB_iC_i}x+\\w") == "29 index-repeats: ?");
}

TEST_CASE("a free index that is summed in a factor of the term clashes") {
  Statements vectors;
  for (const char* letter : {"A", "B", "C"}) vectors.declare({letter, 1, false});
  CHECK(vectors.meaning("(A_iB_i)C_i") == "11 index-clash: ?");
  CHECK(vectors.meaning("A_i\\sum_i B_i") == "3 index-clash: ?");
  CHECK(meaning("(A_jB_j)C_i") == "(multiply (index-sum j (multiply A[j] B[j])) C[i])");
}

TEST_CASE("one letter summed in two factors is two dummies") {
  CHECK(meaning("(A_iB_i)(C_iD_i)") ==
        "(multiply (index-sum i (multiply A[i] B[i])) (index-sum i (multiply C[i] D[i])))");
}

TEST_CASE("a slash divides all that stands before it") {
  CHECK(meaning("a/b") == "(divide a b)");
  CHECK(meaning("ab/c") == "(divide (multiply a b) c)");
  CHECK(meaning("a/(bc)") == "(divide a (multiply b c))");
  CHECK(meaning("\\mathbf{A}\\cdot\\mathbf{B}/2") == "(divide (dot \\mathbf{A} \\mathbf{B}) 2)");
}

TEST_CASE("a slash between numbers is a fraction") {
  CHECK(meaning("1/2\\,m") == "(multiply (divide 1 2) m)");
  CHECK(meaning("1/2\\,\\mathbf{A}\\cdot\\mathbf{B}") ==
        "(multiply (divide 1 2) (dot \\mathbf{A} \\mathbf{B}))");
}

TEST_CASE("what stands behind a divisor can belong to it or not") {
  CHECK(meaning("a/bc") == "2 ambiguous-reading: ?");
  CHECK(meaning("1/2m\\,v") != "(multiply (divide 1 (multiply 2 m)) v)");
  CHECK(meaning("a/b/c") == "2 ambiguous-reading: ?");
}

TEST_CASE("a vector or a free index below a fraction is not divided by") {
  CHECK(meaning("\\frac{\\mathbf A}{B}") == "(divide \\mathbf{A} B)");
  CHECK(meaning("\\frac{A}{\\mathbf{B}}") == "10 rank-mismatch: ?");
  CHECK(meaning("a/\\mathbf{B}") == "3 rank-mismatch: ?");
  CHECK(meaning("\\frac{1}{A_i}") == "12 unsupported: ?");
}

TEST_CASE("a letter before a bracket with one letter can be a function") {
  CHECK(meaning("f(x)") == "1 ambiguous-reading: ?");
  CHECK(meaning("a\\,\\omega(t)") == "4 ambiguous-reading: ?");
  CHECK(meaning("A_i(x)") == "1 ambiguous-reading: ?");
  CHECK(meaning("f(x,y)") == "2 unsupported: ?");
}

TEST_CASE("a letter before a bracket with a sum, or with a declared letter, is a factor") {
  CHECK(meaning("f(x+y)") == "1 ambiguous-reading: ?");
  CHECK(meaning("m(x+y)") == "(multiply m (add x y))");
  CHECK(meaning("\\delta_{ij}(x)") == "(multiply delta[i,j] x)");
  CHECK(meaning("(x)f") == "(multiply x f)");
  CHECK(Statements().declare({"x", 0, false}).meaning("f(x)") == "(multiply f x)");
}

TEST_CASE("a bare d before a letter can be a differential") {
  CHECK(meaning("d\\mathbf r") == "1 ambiguous-reading: ?");
  CHECK(meaning("2dx") == "2 ambiguous-reading: ?");
  CHECK(Statements().declare({"d", 0, false}).meaning("dx") == "(multiply d x)");
}
