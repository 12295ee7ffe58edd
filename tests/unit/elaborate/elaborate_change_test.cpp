// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives, ∇ and named functions.
#include "catch.h"
#include "elaborate/elaborated.h"

using namespace rigor;

TEST_CASE("dots and d/dt are the same rate") {
  CHECK(meaning("\\dot{\\mathbf{A}} = \\frac{d\\mathbf{A}}{dt}") ==
        "\\dot{\\mathbf{A}} = \\dot{\\mathbf{A}}");
  CHECK(meaning("\\ddot{x} = \\frac{d^2x}{dt^2}") == "\\ddot{x} = \\ddot{x}");
  CHECK(meaning("\\frac{d}{dt}(ab)") == "(add (multiply \\dot{a} b) (multiply a \\dot{b}))");
}

TEST_CASE("a coordinate's derivative has the axis behind") {
  CHECK(meaning("\\partial_j A_i") == "\\partial A[i,j]");
  CHECK(meaning("\\partial_i A_i") == "(index-sum i \\partial A[i,i])");
  CHECK(meaning("\\frac{\\partial\\phi}{\\partial y}") == "\\partial \\phi[2]");
  CHECK(meaning("\\partial_i x_j") == "delta[j,i]");
}

TEST_CASE("∇ is written out in components") {
  CHECK(meaning("\\nabla\\phi") == "(tuple \\partial \\phi[1] \\partial \\phi[2] \\partial \\phi[3])");
  CHECK(meaning("\\nabla\\cdot\\mathbf{A}") ==
        "(add \\partial \\mathbf{A}[1,1] \\partial \\mathbf{A}[2,2] \\partial \\mathbf{A}[3,3])");
  CHECK(meaning("\\nabla\\times\\mathbf{A}")
            .starts_with("(tuple (add \\partial \\mathbf{A}[3,2] (negate \\partial \\mathbf{A}[2,3]))"));
  CHECK(meaning("\\nabla^2\\phi").starts_with("(add \\partial \\partial \\phi[1,1]"));
  CHECK(meaning("(\\mathbf{A}\\cdot\\nabla)\\phi")
            .starts_with("(add (multiply \\mathbf{A}[1] \\partial \\phi[1])"));
}

TEST_CASE("what ∇ acts on is a vector or a scalar, and clear") {
  CHECK(meaning("\\nabla\\cdot a").ends_with("rank-mismatch: ?"));
  CHECK(meaning("\\nabla a b").ends_with("ambiguous-reading: ?"));
  CHECK(meaning("\\frac{\\partial L}{\\partial q}") == "\\partial_{q} L");
}

TEST_CASE("functions are of scalars without free indices") {
  CHECK(meaning("\\sin^2 a") == "(power (sin a) 2)");
  CHECK(meaning("\\sin\\mathbf{A}") == "1 rank-mismatch: ?");
  CHECK(meaning("\\cos A_i") == "1 unsupported: ?");
  CHECK(meaning("e^{a}") == "(exp a)");
}

TEST_CASE("traces and determinants are of tensors") {
  CHECK(meaning("\\det\\overleftrightarrow{S}").starts_with("(determinant "));
  CHECK(meaning("\\det S_{ij}").starts_with("(determinant S[1,1] S[1,2]"));
  CHECK(meaning("\\det\\mathbf{A}").find("?") != std::string::npos);
}
