// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/token/remarks.h"

#include "catch.h"

namespace rigor {
namespace {

TEST_CASE("words that restrict an equation are not read") {
  CHECK(remark_of("if ") == Remark::unread);
  CHECK(remark_of("cyclic in i") == Remark::unread);
  CHECK(remark_of("cyclic permutations") == Remark::unread);
  CHECK(remark_of("when the axes are principal") == Remark::unread);
}

TEST_CASE("words that take the sum from repeated indices are told apart") {
  for (const char* words :
       {"no sum", "(no sum)", "no summation", "not summed", "no sum over i", "(no sum on $j$)", "with no sum",
        "no summation over repeated indices", "no implied summation", "not summed over $\\alpha$"}) {
    INFO(words);
    CHECK(remark_of(words) == Remark::no_sum);
  }
  CHECK(remark_of("no sum if i is small") == Remark::unread);
  CHECK(remark_of("sum over i") == Remark::unread);
}

TEST_CASE("words that say an equation for the other axes are told apart") {
  for (const char* words : {"and cyclic permutations", "and cyclic permutations of 1, 2, 3",
                            "(and cyc. perm.)", "and cyclically", "etc.", ", etc.", "plus cyclic",
                            "and cyclic permutations of $x, y, z$", "and cyclically for the others"}) {
    INFO(words);
    CHECK(remark_of(words) == Remark::cyclic);
  }
  CHECK(remark_of("and cyclic permutations of i, j, k") == Remark::unread);
  CHECK(remark_of("and cyclic in i") == Remark::unread);
}

TEST_CASE("words that name an equation or its source say nothing about it") {
  CHECK(remark_of("(orbital + spin)") == Remark::remark);
  CHECK(remark_of("Lagrange's identity") == Remark::remark);
  CHECK(remark_of("by Jacobi") == Remark::remark);
}

TEST_CASE("any other words are not read, and no sign among them is passed over") {
  CHECK(remark_of("to first order") == Remark::unread);
  CHECK(remark_of("in vacuo") == Remark::unread);
  for (const char* words :
       {"grad", "Re", "det", "Newtom's law", "by Jacobj", "energy = 2", "no sum over i<j", "and if so"}) {
    INFO(words);
    CHECK(remark_of(words) == Remark::unread);
  }
}

TEST_CASE("the symbols among words are known by name") {
  CHECK(symbols_in_words("for all $\\alpha$ and $x_i$") == std::set<std::string>{"alpha", "i", "x"});
  CHECK(symbols_in_words("Newton's second law").empty());
}

TEST_CASE("words in brackets or with their source stand apart from the equation") {
  CHECK(stands_apart(" (distributive law)"));
  CHECK(stands_apart("by Jacobi"));
  CHECK_FALSE(stands_apart("energy"));
}

TEST_CASE("a quantifier over everything is harmless, one over some is not") {
  CHECK(remark_of("for all vectors") == Remark::quantifier);
  CHECK(remark_of("for all perpendicular vectors") == Remark::unread);
}

TEST_CASE("words between two equations join them") {
  CHECK(remark_of("and") == Remark::connective);
  CHECK(remark_of("so that") == Remark::connective);
}

}  // namespace
}  // namespace rigor
