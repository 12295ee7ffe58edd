// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/notation/index_condition.h"

#include <algorithm>

#include "catch.h"

namespace {

using namespace rigor;

/// The tuples for which the condition holds, e.g. `123 231 312`; `?` where the words are not understood.
std::string tuples(const std::string& words, const std::vector<std::string>& letters = {"i", "j", "k"}) {
  const auto holds = read_index_condition(words, letters);
  if (!holds) return "?";
  std::string text;
  for (std::size_t at = 0; at < holds->size(); ++at) {
    if (!(*holds)[at]) continue;
    std::string digits;
    for (std::size_t k = 0, rest = at; k < letters.size(); ++k, rest /= 3)
      digits += static_cast<char>('1' + rest % 3);
    std::reverse(digits.begin(), digits.end());
    text += (text.empty() ? "" : " ") + digits;
  }
  return text;
}

std::string pairs(const std::string& words) { return tuples(words, {"i", "j"}); }

}  // namespace

TEST_CASE("an index condition lists tuples of axes") {
  CHECK(tuples("ijk = 123, 231, 312") == "123 231 312");
  CHECK(tuples("(i,j,k) = (1,3,2)") == "132");
  CHECK(tuples("\\text{if } ijk = 123 \\text{ or } 231") == "123 231");
  CHECK(tuples("ijk = xyz") == "123");
}

TEST_CASE("cyclic permutations of a tuple are its three rotations") {
  CHECK(tuples("ijk = 123 \\text{ or cyclic permutations}") == "123 231 312");
  CHECK(tuples("ijk = 132 \\text{ and cyclic}") == "132 213 321");
}

TEST_CASE("even and odd permutations are those of 123") {
  CHECK(tuples("(i,j,k) is an even permutation of (1,2,3)") == "123 231 312");
  CHECK(tuples("(i,j,k) is an odd permutation of (1,2,3)") == "132 213 321");
  CHECK(tuples("\\text{if } (i,j,k) \\text{ is an odd permutation}") == "132 213 321");
  CHECK(tuples("(i,j,k) is an even permutation of (1,3,2)") == "?");
}

TEST_CASE("two letters are equal or not") {
  CHECK(pairs("i = j") == "11 22 33");
  CHECK(pairs("\\text{if } i = j") == "11 22 33");
  CHECK(pairs("i \\ne j") == "12 13 21 23 31 32");
  CHECK(pairs("for $i \\neq j$") == "12 13 21 23 31 32");
}

TEST_CASE("a condition on two of three letters leaves the third free") {
  const auto holds = read_index_condition("i = k", {"i", "j", "k"});
  REQUIRE(holds.has_value());
  CHECK(std::count(holds->begin(), holds->end(), true) == 9);
}

TEST_CASE("any two equal indices are 21 of the 27 tuples") {
  const auto holds = read_index_condition("any two indices are equal", {"i", "j", "k"});
  REQUIRE(holds.has_value());
  CHECK(std::count(holds->begin(), holds->end(), true) == 21);
  CHECK_FALSE((*holds)[5]);  // 123
  CHECK((*holds)[0]);        // 111
}

TEST_CASE("otherwise holds everywhere") {
  CHECK(pairs("\\text{otherwise}") == "11 12 13 21 22 23 31 32 33");
  CHECK(pairs("else") == pairs("otherwise"));
}

TEST_CASE("the letters of a condition stand in any order") {
  CHECK(tuples("jik = 123") == "213");
  CHECK(tuples("kij = 123") == "231");
}

TEST_CASE("words that are not understood are no condition") {
  CHECK(tuples("x = 1") == "?");
  CHECK(tuples("ijl = 123") == "?");
  CHECK(tuples("no two indices are equal") == "?");
  CHECK(tuples("not ijk = 123") == "?");
  CHECK(tuples("an anticyclic permutation of 123") == "?");
  CHECK(pairs("i < j") == "?");
}
