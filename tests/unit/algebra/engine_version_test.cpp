// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/engine/engine_version.h"

#include <regex>

#include "catch.h"

namespace rigor {
namespace {

TEST_CASE("the exact side names its libraries with the versions that it was built with") {
  const std::string text = engine_version();
  INFO(text);
  CHECK(std::regex_match(text, std::regex(R"(GiNaC \d+\.\d+\.\d+, CLN \d+\.\d+\.\d+)")));
}

}  // namespace
}  // namespace rigor
