// SPDX-License-Identifier: GPL-3.0-or-later
#include "catch.h"
#include "elaborate/elaborated.h"

namespace {

using namespace rigor;

std::string cases(const std::string& left, const std::string& rows) {
  return meaning(left + " = \\begin{cases}" + rows + "\\end{cases}");
}

}  // namespace

TEST_CASE("cases over index values are a table") {
  CHECK(cases("\\delta_{ij}", "1 & \\text{if } i = j\\\\ 0 & \\text{if } i\\ne j") ==
        "delta[i,j] = (table[i,j]:0,1,1,1,0,1,1,1,0 1 0)");
  CHECK(
      cases("\\epsilon_{ijk}",
            "1 & ijk = 123, 231, 312\\\\ -1 & ijk = 132, 213, 321\\\\ 0 & \\text{otherwise}") ==
      "epsilon[i,j,k] = (table[i,j,k]:2,2,2,2,2,0,2,1,2,2,2,1,2,2,2,0,2,2,2,0,2,1,2,2,2,2,2 1 (negate 1) 0)");
}

TEST_CASE("the first case that holds counts") {
  CHECK(cases("T_{ij}", "a & i = j\\\\ b & i = j\\\\ c & \\text{otherwise}") ==
        "T[i,j] = (table[i,j]:0,2,2,2,0,2,2,2,0 a b c)");
}

TEST_CASE("cases that leave an index value out are not read") {
  CHECK(cases("\\delta_{ij}", "1 & i = j") == "15 unsupported: delta[i,j] = ?");
}

TEST_CASE("a condition that is not understood is reported at its words") {
  CHECK(cases("\\delta_{ij}", "1 & x = y\\\\ 0 & \\text{otherwise}") == "32 unsupported: delta[i,j] = ?");
}

TEST_CASE("cases without index letters on the left side are not read") {
  CHECK(cases("a", "1 & x\\\\ 0 & y") == "5 unsupported: a = ?");
}

TEST_CASE("a case has no indices of its own") {
  CHECK(cases("T_{ij}", "A_i & i = j\\\\ 0 & \\text{otherwise}") == "23 unsupported: T[i,j] = ?");
}
