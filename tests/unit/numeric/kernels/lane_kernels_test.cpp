// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/lane/lane_kernels.h"

#include <string>

#include "catch.h"

namespace rigor {
namespace {

TEST_CASE("there are lane kernels for every machine, and the widest are taken") {
  const auto& sets = runnable_lane_kernels();
  REQUIRE_FALSE(sets.empty());
  CHECK(std::string(sets.front()->instruction_set) == "baseline");
  for (std::size_t k = 1; k < sets.size(); ++k) CHECK(sets[k - 1]->lanes < sets[k]->lanes);
  CHECK(&lane_kernels() == sets.back());
}

}  // namespace
}  // namespace rigor
