// SPDX-License-Identifier: GPL-3.0-or-later
// The closed form of a free body's motion beside the motion that a scene integrates from the notes'
// equations.
#include "scene/free_motion.h"

#include <fmt/format.h>

#include <cmath>

#include "scene/played_scene.h"

namespace rigor {
namespace {

struct Scene {
  std::string spin;
  std::string torque = "[0, 0, 0]";
};
Played played(const Scene& scene) {
  return Played("spin = " + scene.spin +
                    "\n[motion]\nequations = \"(22)\"\nduration = \"20 s\"\nrows = 21\ntolerance = 1e-12\n"
                    "[values]\n'\\boldsymbol{\\tau}' = " +
                    scene.torque + "\n[ask]\nquantities = ['\\boldsymbol{\\omega}(t)']\n",
                sample());
}

const Position moments{10, 20, 26};  // of `sample()`

Vector3 free_rates(const Vector3& w) {
  return {(20. - 26) / 10 * w[1] * w[2], (26. - 10) / 20 * w[2] * w[0], (10. - 20) / 26 * w[0] * w[1]};
}

TEST_CASE("a scene without torque moves in closed form, as the notes' equations integrate", "[scene]") {
  for (const Vector3& spin : {Vector3{1, 2, 3}, Vector3{0.01, 2, -0.02}, Vector3{-1, 0.3, 0.2}}) {
    const MotionRequest request{
        .spin = spin, .duration = 20, .rows = 21, .tolerance = 1e-12, .orientation = Quaternion{1, 0, 0, 0}};
    const auto exact = free_motion(free_rates, moments, request);
    const Motion stepped = integrate(free_rates, request);
    REQUIRE(exact);
    CHECK(exact->times == stepped.times);
    for (std::size_t row = 0; row < stepped.times.size(); ++row) {
      double along = 0;
      for (std::size_t i = 0; i < 4; ++i) along += exact->orientations[row][i] * stepped.orientations[row][i];
      CHECK(std::abs(std::abs(along) - 1) < 1e-8);
      for (std::size_t i = 0; i < 3; ++i) {
        CHECK(std::abs(exact->spins[row][i] - stepped.spins[row][i]) < 1e-8);
      }
    }
    const Played scene = played({fmt::format("[{}, {}, {}]", spin[0], spin[1], spin[2])});
    INFO(scene.messages());
    REQUIRE(scene.result.motion);
    CHECK(scene.result.motion->closed_form);
    for (std::size_t row = 0; row < stepped.times.size(); ++row) {
      for (std::size_t i = 0; i < 3; ++i) {
        CHECK(std::abs(scene.result.motion->spins[row][i] - stepped.spins[row][i]) < 1e-8);
      }
    }
  }
}

TEST_CASE("a law that is not a free body's is integrated as the notes say", "[scene]") {
  const Played pushed = played({"[1, 2, 3]", "[0.1, 0, 0]"});
  REQUIRE(pushed.result.motion);
  CHECK_FALSE(pushed.result.motion->closed_form);
  CHECK(pushed.result.motion->steps > 0);

  const MotionRequest request{.spin = {1, 2, 3}, .duration = 20, .rows = 21};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto wrong_sign = [&](const Vector3& w) {
      Vector3 rates = free_rates(w);
      rates[i] = -rates[i];
      return rates;
    };
    CHECK_FALSE(free_motion(wrong_sign, moments, request));
    const auto drag = [&](const Vector3& w) {
      Vector3 rates = free_rates(w);
      rates[i] -= 1e-11 * w[i];
      return rates;
    };
    CHECK_FALSE(free_motion(drag, moments, request));
  }
  CHECK(free_motion(free_rates, moments, request));
  CHECK_FALSE(free_motion(free_rates, {10, 20, 26 + 1e-10}, request));
  CHECK_FALSE(free_motion(free_rates, moments, {.spin = {0, 0, 0}, .duration = 20}));
}

}  // namespace
}  // namespace rigor
