// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/lane/lane_kernels.h"

#include <cstdlib>
#include <string>

#include "catch.h"

namespace rigor {
namespace {

TEST_CASE("kernels of an instruction set are found by its name, and else the widest") {
  for (const LaneKernels* kernels : runnable_lane_kernels())
    CHECK(&lane_kernels_named(kernels->instruction_set) == kernels);
  CHECK(&lane_kernels_named("x86_64_v9") == runnable_lane_kernels().back());
  CHECK(&lane_kernels_named("") == runnable_lane_kernels().back());
}

TEST_CASE("there are lane kernels for every machine, and the widest are taken") {
  const auto& sets = runnable_lane_kernels();
  REQUIRE_FALSE(sets.empty());
  CHECK(std::string(sets.front()->instruction_set) == "baseline");
  for (std::size_t k = 1; k < sets.size(); ++k) CHECK(sets[k - 1]->lanes < sets[k]->lanes);
  if (std::getenv("RIGOR_INSTRUCTION_SET") == nullptr) CHECK(&lane_kernels() == sets.back());
}

}  // namespace
}  // namespace rigor
