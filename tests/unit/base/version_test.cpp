// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/version.h"

#include <algorithm>

#include "catch.h"

namespace rigor {
namespace {

TEST_CASE("the version is three numbers") {
  CHECK(std::count(version.begin(), version.end(), '.') == 2);
  CHECK(version.find_first_not_of("0123456789.") == std::string_view::npos);
}

}  // namespace
}  // namespace rigor
