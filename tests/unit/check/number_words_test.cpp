// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/word/number_words.h"

#include "catch.h"

using rigor::word_on_numbers;

TEST_CASE("words on numbers are heeded in all their forms", "[check]") {
  CHECK(word_on_numbers("rounded up to the next") == "rounded");
  CHECK(word_on_numbers("roughly") == "roughly");
  CHECK(word_on_numbers("we add in quadrature") == "quadrature");
  CHECK(word_on_numbers("in binary") == "binary");
}

TEST_CASE("words on cases say nothing of numbers", "[check]") {
  CHECK_FALSE(word_on_numbers("uniform motion in the plane"));
  CHECK_FALSE(word_on_numbers("perpendicular sides at the surface"));
  CHECK_FALSE(word_on_numbers(""));
}
