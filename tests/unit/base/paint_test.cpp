// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/paint.h"

#include "catch.h"

namespace rigor {
namespace {

TEST_CASE("a painted text ends with the sequence that ends all colours") {
  CHECK(paint("proved", Paint::good, true) == "\x1b[32mproved\x1b[0m");
  CHECK(paint("refuted", Paint::bad, true) == "\x1b[1;31mrefuted\x1b[0m");
}

TEST_CASE("without colour, without a style and without a text nothing is added") {
  CHECK(paint("proved", Paint::good, false) == "proved");
  CHECK(paint("proved", Paint::plain, true) == "proved");
  CHECK(paint("", Paint::good, true).empty());
}

}  // namespace
}  // namespace rigor
