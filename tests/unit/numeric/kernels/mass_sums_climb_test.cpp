// SPDX-License-Identifier: GPL-3.0-or-later
// The bounds that come with sums over points, against the worst clouds that a search finds.
#include "catch.h"
#include "numeric/climb.h"
#include "numeric/kernels/mass_sums.h"
#include "numeric/kernels/point_clouds.h"

namespace rigor {
namespace {

/// One point, or all of one coordinate, somewhere else.
PointCloud changed_cloud(PointCloud cloud, SplitMix& bits) {
  const std::size_t i = bits.below(4);
  const double size = std::pow(10, 12 * uniform_sign(bits));
  if (bits.below(4) == 0) {
    const double by = i < 3 ? size : 1;
    for (double& x : cloud.columns[i]) x = i < 3 ? x + by : x * size;
  } else {
    double& x = cloud.columns[i][bits.below(cloud.size())];
    x = i < 3 ? size * uniform_sign(bits) : size * uniform(bits);
  }
  return cloud;
}

TEST_CASE("climbing for the worst error of sums over points ends below their bounds", "[mass sums]") {
  for (const std::size_t count : {3, 8, 70}) {
    SplitMix bits(count);
    const auto changed = [&](const PointCloud& cloud) { return changed_cloud(cloud, bits); };
    const auto plain = [](const PointCloud& cloud) {
      const auto sums = mass_sums(cloud.points());
      if (!sums) return 0.0;
      const double error = ExactMassSums(cloud).error_of(sums->inertia);
      CHECK(error <= sums->error);
      return error == 0 ? 0 : error / sums->error;
    };
    const auto sharp = [](const PointCloud& cloud) {
      const auto sums = sharp_mass_sums(cloud.points());
      if (!sums) return 0.0;
      const double error = ExactMassSums(cloud).error_of(sums->inertia);
      CHECK(error <= sums->error);
      return error == 0 ? 0 : error / sums->error;
    };
    const double worst = climbed(cube_cloud(count, 1, 17), 400, changed, plain);
    CHECK(worst <= 1);
    CHECK(worst > 0.02);  // so that the bound says something
    CHECK(climbed(cube_cloud(count, 1, 17), 400, changed, sharp) <= 1);
  }
}

}  // namespace
}  // namespace rigor
