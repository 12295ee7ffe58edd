// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/engine/exact_number.h"

#include "catch.h"

using namespace rigor;

TEST_CASE("digits are read as exact numbers", "[algebra]") {
  CHECK(to_text(from_digits("2")) == "2");
  CHECK(to_text(from_digits("0.25")) == "1/4");
  CHECK(to_text(from_digits(".5")) == "1/2");
  CHECK(to_text(from_digits("3.")) == "3");
  CHECK(to_text(from_digits("007")) == "7");
  CHECK(to_text(from_digits(std::string(40, '9'))) == std::string(40, '9'));
}

TEST_CASE("a number that is written is read back", "[algebra]") {
  for (const std::string text : {"0", "3", "-3", "-3/2", "123456789012345678901234567891/7"}) {
    const auto value = from_text(text);
    REQUIRE(value.has_value());
    CHECK(to_text(*value) == text);
  }
  for (const std::string text : {"", "-", "1/0", "1.5", "+1", "1/-2", "x", "1/2/3", " 1"}) {
    CHECK_FALSE(from_text(text).has_value());
  }
}

TEST_CASE("a root is given only if it is rational", "[algebra]") {
  CHECK(exact_root(from_digits("9")).has_value());
  CHECK(to_text(*exact_root(*from_text("4/9"))) == "2/3");
  CHECK(to_text(*exact_root(0)) == "0");
  CHECK_FALSE(exact_root(2).has_value());
  CHECK_FALSE(exact_root(-4).has_value());
}

TEST_CASE("a power may have a negative exponent", "[algebra]") {
  CHECK(to_text(power_of(*from_text("-2/3"), 3)) == "-8/27");
  CHECK(to_text(power_of(*from_text("-2/3"), -3)) == "-27/8");
  CHECK(to_text(power_of(5, 0)) == "1");
}
