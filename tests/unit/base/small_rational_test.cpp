// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/small_rational.h"

#include <limits>

#include "catch.h"

namespace rigor {
namespace {

TEST_CASE("fractions are kept in lowest terms with a positive denominator") {
  CHECK(SmallRational(2, -4) == SmallRational(-1, 2));
  CHECK(SmallRational(0, -7).is_zero());
  CHECK(SmallRational(6, 3).text() == "2");
  CHECK(SmallRational(-3, 2).text() == "-3/2");
}

TEST_CASE("arithmetic is exact") {
  CHECK(SmallRational(1, 2) + SmallRational(1, 3) == SmallRational(5, 6));
  CHECK(SmallRational(1, 2) - SmallRational(1, 2) == SmallRational(0));
  CHECK(SmallRational(2, 3) * SmallRational(3, 4) == SmallRational(1, 2));
  CHECK(SmallRational(2, 3) / SmallRational(-2, 3) == SmallRational(-1));
}

TEST_CASE("what does not fit is no number, nor is what is computed from it") {
  const SmallRational huge(std::numeric_limits<std::int64_t>::max());
  CHECK(huge.is_valid());
  CHECK_FALSE((huge + 1).is_valid());
  CHECK_FALSE((huge * 2).is_valid());
  CHECK_FALSE((huge * 2 + 1).is_valid());
  CHECK_FALSE((SmallRational(1) / (huge * 2)).is_valid());
  CHECK_FALSE((SmallRational(1) / 0).is_valid());
  CHECK_FALSE((huge * 2).is_zero());
}

}  // namespace
}  // namespace rigor
