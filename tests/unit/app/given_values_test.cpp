// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/host/given_values.h"

#include "catch.h"

namespace rigor {

TEST_CASE("numbers of letters are read as they are printed") {
  const auto values = read_given_values("x = 1e-09, \\mathbf{A} = (1, -2.5, 0), I_{1,2} = 3");
  REQUIRE(values);
  CHECK(values->size() == 3);
  CHECK(values->at("x") == std::vector{1e-9});
  CHECK(values->at("\\mathbf{A}") == std::vector{1.0, -2.5, 0.0});
  CHECK(values->at("I_{1,2}") == std::vector{3.0});
}

TEST_CASE("what gives no letter a number is refused with its words") {
  for (const char* text : {"x", "x = ", "= 3", "x = 1/3", "x = (1, 2", "x = inf", "x = 1, y"}) {
    CAPTURE(text);
    CHECK_FALSE(read_given_values(text));
  }
  CHECK(read_given_values("x = 1, y").error().reason == "`y` gives no letter a number");
}

}  // namespace rigor
