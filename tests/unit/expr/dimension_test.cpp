// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/tree/dimension.h"

#include "catch.h"

namespace rigor {
namespace {

const Dimension mass = Dimension::of(BaseQuantity::mass);
const Dimension length = Dimension::of(BaseQuantity::length);
const Dimension time = Dimension::of(BaseQuantity::time);

TEST_CASE("a dimension is printed as a product of powers") {
  CHECK(Dimension().text() == "1");
  CHECK(length.text() == "L");
  CHECK((mass + length * 2 - time * 2).text() == "M L^2 T^{-2}");
  CHECK((length * SmallRational(1, 2)).text() == "L^{1/2}");
  CHECK((Dimension::of(BaseQuantity::amount) * 12).text() == "mol^{12}");
}

TEST_CASE("products add, and a quotient of equals is a number") {
  CHECK((mass + length) - length == mass);
  CHECK((mass - mass).is_none());
  CHECK_FALSE(length.is_none());
}

TEST_CASE("an exponent that does not fit is no dimension") {
  const SmallRational large(std::int64_t{1} << 40);
  CHECK((length * large).is_valid());
  CHECK_FALSE((length * large * large).is_valid());
}

}  // namespace
}  // namespace rigor
