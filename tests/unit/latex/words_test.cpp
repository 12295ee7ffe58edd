// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/token/words.h"

#include "catch.h"

using namespace rigor;

TEST_CASE("words stand between blanks and line breaks", "[latex]") {
  CHECK(words_in(" a  bc\n  d ") == std::vector<std::string_view>{"a", "bc", "d"});
  CHECK(words_in(" \n ").empty());
}

TEST_CASE("a set knows each of its words and no other", "[latex]") {
  const WordSet words("quad qquad");
  CHECK(words.contains("qquad"));
  CHECK_FALSE(words.contains("quad qquad"));
}

TEST_CASE("every word of a row has its value, and the first row counts", "[latex]") {
  const WordMap<int> map{{"one uno", 1}, {"two one", 2}};
  CHECK(map.find("uno") == 1);
  CHECK(map.find("one") == 1);
  CHECK(map.find("two") == 2);
  CHECK_FALSE(map.find("three"));
}

TEST_CASE("a table leads from a word to the next one", "[latex]") {
  const WordTable table("alpha α  beta β");
  CHECK(table.find("beta") == "β");
  CHECK(table.find("α").empty());
}
