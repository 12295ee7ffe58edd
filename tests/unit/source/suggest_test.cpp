// SPDX-License-Identifier: GPL-3.0-or-later
#include "source/suggest.h"

#include <vector>

#include "catch.h"

namespace rigor {
namespace {

TEST_CASE("an insertion, a deletion, a replacement and an exchange of neighbours are one edit each") {
  CHECK(edit_distance("vector", "vectors", 9) == 1);
  CHECK(edit_distance("vector", "vetor", 9) == 1);
  CHECK(edit_distance("vector", "vektor", 9) == 1);
  CHECK(edit_distance("vector", "vecotr", 9) == 1);
  CHECK(edit_distance("vector", "vector", 0) == 0);
  CHECK(edit_distance("", "abc", 9) == 3);
  CHECK(edit_distance("ca", "abc", 9) == 3);
}

TEST_CASE("beyond the limit the distance is the limit and one") {
  CHECK(edit_distance("vector", "scalar", 2) == 3);
  CHECK(edit_distance("a", "abcdefgh", 2) == 3);
  CHECK(edit_distance("abcd", "wxyz", 3) == 4);
  CHECK(edit_distance("abcd", "wxyz", 4) == 4);
}

TEST_CASE("an exchange is seen at every limit that allows it") {
  CHECK(edit_distance("ab", "ba", 1) == 1);
  CHECK(edit_distance("abcd", "badc", 2) == 2);
  CHECK(edit_distance("abcd", "badc", 1) == 2);
}

TEST_CASE("the nearest word is suggested, and the first of two that are equally near") {
  const std::vector<std::string> known{"vector", "tensor", "scalar", "sector"};
  CHECK(suggest("vectro", known) == "vector");
  CHECK(suggest("rector", known) == "vector");
  CHECK(suggest("scaler", known) == "scalar");
}

TEST_CASE("a word farther than a third of its length is no suggestion") {
  const std::vector<std::string> known{"particles"};
  CHECK(suggest("partcles", known) == "particles");
  CHECK_FALSE(suggest("parcl", known));
  CHECK_FALSE(suggest("", known));
  CHECK_FALSE(suggest("vector", std::vector<std::string>{}));
}

TEST_CASE("a word of which no letter stays is no suggestion") {
  CHECK_FALSE(suggest("x", std::vector<std::string>{"y"}));
  CHECK(suggest("x", std::vector<std::string>{"x'"}) == "x'");
}

TEST_CASE("a word of a million letters has no suggestion") {
  CHECK_FALSE(suggest(std::string(1'000'000, 'a'), std::vector<std::string>{std::string(1'000'000, 'b')}));
}

}  // namespace
}  // namespace rigor
