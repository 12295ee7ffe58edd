// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/kernels/point_pass.h"

#include <pthread.h>

#include <cstring>

#include "catch.h"
#include "numeric/kernels/point_clouds.h"

namespace rigor {
namespace {

/// New threads ask for more memory than there are addresses, and are refused.
class NoThreads {
 public:
  NoThreads() {
    ::pthread_getattr_default_np(&before_);
    pthread_attr_t huge;
    ::pthread_attr_init(&huge);
    ::pthread_attr_setstacksize(&huge, std::size_t{1} << 60);
    ::pthread_setattr_default_np(&huge);
    ::pthread_attr_destroy(&huge);
  }
  ~NoThreads() {
    ::pthread_setattr_default_np(&before_);
    ::pthread_attr_destroy(&before_);
  }
  NoThreads(const NoThreads&) = delete;
  NoThreads& operator=(const NoThreads&) = delete;

 private:
  pthread_attr_t before_{};
};

bool are_same(const PointSums& a, const PointSums& b) {
  return std::memcmp(a.high, b.high, sizeof a.high) == 0 && std::memcmp(a.low, b.low, sizeof a.low) == 0;
}

TEST_CASE("a pass over points gives the same bits with threads, with fewer than asked for, and scaled") {
  const PointCloud cloud = cube_cloud(40 * chunk_points + 77, 3, 31);
  const SharpPosition centre{{{3, 0}, {-1, 0}, {2, 0}}};
  const SumPoints kernel = lane_kernels().sum_points;
  for (const PointScale& scale : {PointScale{}, PointScale{-3, 5}}) {
    const PointSums one = point_pass(kernel, cloud.points(), scale, centre, 1);
    for (const std::size_t threads : {2U, 3U, 5U})
      CHECK(are_same(point_pass(kernel, cloud.points(), scale, centre, threads), one));
    const NoThreads refused;
    CHECK(are_same(point_pass(kernel, cloud.points(), scale, centre, 5), one));
  }
}

}  // namespace
}  // namespace rigor
