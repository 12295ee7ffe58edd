// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/kernels/symmetric_top_families.h"

#include <cmath>

#include "catch.h"

namespace rigor {
namespace {

TEST_CASE(
    "nearly symmetric tops are the same body at every distance, with the gap that they are named after") {
  const auto tops = nearly_symmetric_tops();
  REQUIRE(tops.size() == 15);
  for (std::size_t n = 0; n < tops.size(); ++n) {
    INFO(tops[n].name);
    const NearlySymmetricTop& near = tops[n - n % 3];
    REQUIRE(tops[n].masses.size() == 1024);
    CHECK(tops[n].masses == near.masses);
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 1024; ++k)
        REQUIRE(tops[n].positions[i][k] - tops[n].distance == near.positions[i][k]);
    // (Ω_1)² of the least moment is of the order of 1, the other two are small as the gap, and of different
    // sign
    CHECK(tops[n].squared_frequencies[0] > 0.01);
    CHECK(tops[n].squared_frequencies[1] < 0);
    CHECK(-tops[n].squared_frequencies[1] < 10 * tops[n].gap);
    CHECK(-tops[n].squared_frequencies[1] > tops[n].gap / 10);
    CHECK(tops[n].squared_frequencies[2] > 0);
  }
}

}  // namespace
}  // namespace rigor
