// SPDX-License-Identifier: GPL-3.0-or-later
// The closed form of a free body's motion beside the motion that a scene integrates from the notes'
// equations.
#include <cmath>

#include "numeric/kernels/torque_free.h"
#include "numeric/kernels/torque_free_attitude.h"
#include "scene/played_scene.h"

namespace rigor {
namespace {

TEST_CASE("a scene without torque moves as the closed form, spin and attitude", "[scene]") {
  for (const std::string spin : {"[1, 2, 3]", "[0.01, 2, -0.02]", "[-1, 0.3, 0.2]"}) {
    const Played played(
        "spin = " + spin +
            "\n[motion]\nequations = \"(22)\"\nduration = \"20 s\"\nrows = 21\ntolerance = 1e-12\n"
            "[values]\n'\\boldsymbol{\\tau}' = [0, 0, 0]\n[ask]\nquantities = "
            "['\\boldsymbol{\\omega}(t)']\n",
        sample());
    INFO(spin << ": " << played.messages());
    REQUIRE(played.result.motion);
    const Motion& motion = *played.result.motion;
    REQUIRE(motion.spins.size() == 21);
    const Position moments{10, 20, 26};  // of `sample()`
    const auto exact = TorqueFree::make(moments, motion.spins[0]);
    const auto attitude = TorqueFreeAttitude::make(moments, motion.spins[0]);
    REQUIRE(exact);
    for (std::size_t row = 0; row < motion.times.size(); ++row) {
      const Position expected = exact->spin(motion.times[row]);
      for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(motion.spins[row][i] - expected[i]) < 1e-8);
      if (motion.orientations.empty()) continue;
      const Quaternion turn = composed(motion.orientations[0], attitude->at(motion.times[row]));
      double along = 0;
      for (std::size_t i = 0; i < 4; ++i) along += turn[i] * motion.orientations[row][i];
      CHECK(std::abs(std::abs(along) - 1) < 1e-8);
    }
  }
}

TEST_CASE("the closed form is not the motion of a body that a torque turns", "[scene]") {
  const Played played(
      "spin = [1, 2, 3]\n[motion]\nequations = \"(22)\"\nduration = \"20 s\"\nrows = 21\n[values]\n"
      "'\\boldsymbol{\\tau}' = [0.1, 0, 0]\n[ask]\nquantities = ['\\boldsymbol{\\omega}(t)']\n",
      sample());
  REQUIRE(played.result.motion);
  const auto exact = TorqueFree::make({10, 20, 26}, played.result.motion->spins[0]);
  CHECK(std::abs(exact->spin(20)[0] - played.result.motion->spins[20][0]) > 1e-3);
}

}  // namespace
}  // namespace rigor
