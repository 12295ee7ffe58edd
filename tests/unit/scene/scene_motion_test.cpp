// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes that move: the law of motion, what stays constant, and the axes and orientation of the motion.
#include <cmath>

#include "catch.h"
#include "expr/build.h"
#include "scene/played_scene.h"

namespace rigor {
namespace {

TEST_CASE("equations that leave the torque open are no law of motion", "[scene]") {
  const Played played(
      "spin = [1, 2, 3]\n[motion]\nequations = \"(22)\"\nduration = 1\n[ask]\nquantities = "
      "['\\boldsymbol{\\omega}(t)']\n",
      sample());
  CHECK(played.messages().find("`(22)` gives no law of motion: ") != std::string::npos);
  CHECK(!played.result.motion);
}

TEST_CASE("a rod's spin about itself is not determined, and the axis is named", "[scene]") {
  const Body rod = *point_masses("rod", {1, 1}, {{0, 0, 1}, {0, 0, -1}});
  const Played played(
      std::string("spin = [1, 2, 3]\n[ask]\nquantities = ['\\boldsymbol{\\omega}(t)']\n") + euler, rod);
  CHECK(played.messages().find("do not determine the rate of the spin's component 3") != std::string::npos);
}

TEST_CASE("a torque moves a body that is at rest, or nearly", "[scene]") {
  for (const std::string spin : {"[0, 0, 0]", "[1e-6, 0, 0]"}) {
    const Played played("spin = " + spin +
                            "\n[motion]\nequations = \"(22)\"\nduration = \"20 s\"\n[values]\n"
                            "'\\boldsymbol{\\tau}' = [1, 0, 0]\n[ask]\nquantities = "
                            "['\\boldsymbol{\\omega}(t)']\n",
                        sample());
    INFO(spin);
    CHECK(played.messages() == "");
    REQUIRE(played.result.motion);
    REQUIRE(played.result.motion->spins.size() == 501);
    CHECK(played.result.motion->spins[500][0] == Approx(2).epsilon(1e-6));  // τ t / I₁
    CHECK(played.result.motion->spins[250][0] - played.result.motion->spins[0][0] ==
          Approx(1).epsilon(1e-12));
  }
}

TEST_CASE("a spin whose square is not finite is a diagnostic, and there is no motion", "[scene]") {
  const std::string ask = "[ask]\nquantities = ['\\boldsymbol{\\omega}(t)']\n";
  const Played played("spin = [1.7e308, 1.7e308, 0]\n" + ask + euler, sample());
  CHECK(played.messages().find("the equations are not finite at the initial spin") != std::string::npos);
  CHECK(!played.result.motion);
}

TEST_CASE("a row that is not finite is said, and is not constant", "[scene]") {
  // 1/ω₁ with ω₁ = τ t / I₁ − 1 at the tenth second.
  const Played played(
      "spin = [-1, 0, 0]\n[motion]\nequations = \"(22)\"\nduration = \"20 s\"\nrows = 3\n[values]\n"
      "'\\boldsymbol{\\tau}' = [1, 0, 0]\n[ask]\nquantities = ['\\boldsymbol{\\omega}(t)', "
      "'\\sqrt{-\\omega_1}(t)']\n",
      sample());
  CHECK(played.messages() == "bad-scene: `\\sqrt{-\\omega_1}(t)` is not finite at 20 s\n");
  REQUIRE(played.result.drifts.size() == 2);
  CHECK(std::isnan(played.result.drifts[1].relative));
  CHECK(!played.result.drifts[1].constant);
}

TEST_CASE("what changes is not constant, however coarse the integration", "[scene]") {
  const auto drift = [](const std::string& tolerance) {
    const Played played(
        "spin = [0, 0, 1]\n[motion]\nequations = \"(22)\"\nduration = 1\ntolerance = " + tolerance +
            "\n[values]\n'\\boldsymbol{\\tau}' = [0, 0, 13]\n[ask]\nquantities = "
            "['\\boldsymbol{\\omega}(t)']\n",
        sample());
    REQUIRE(played.result.drifts.size() == 1);
    return played.result.drifts[0];
  };
  CHECK(drift("1e-2").relative == Approx(1.0 / 3));
  CHECK(!drift("1e-2").constant);
  CHECK(!drift("1e-10").constant);
}

TEST_CASE("the orientation is that of the axes along which the spin is given", "[scene]") {
  const std::string lines = std::string(
      "spin = [1, 2, 3]\norientation = { axis = [1, 1, 0], angle = \"50 deg\" }\n[ask]\nquantities = "
      "['\\boldsymbol{\\omega}(t)']\n");
  const Played played("axes = \"body\"\n" + lines + euler, turned_cross(3, 2, 1));
  const Played plain("axes = \"principal\"\n" + lines + euler, turned_cross(3, 2, 1));
  CHECK(played.messages() == "");
  REQUIRE(played.result.motion);
  REQUIRE(plain.result.motion);
  // The first spin in space is the one given, turned by 50 degrees, whatever axes the motion is followed
  // along.
  const Vector3 expected = turned(plain.result.motion->orientations[0], {1, 2, 3});
  const Vector3 in_space = turned(played.result.motion->orientations[0], played.result.motion->spins[0]);
  CHECK(played.result.motion->spins[0][0] == Approx(std::sqrt(0.75) + 1));
  for (std::size_t i = 0; i < 3; ++i) CHECK(in_space[i] == Approx(expected[i]).epsilon(1e-14));
}

TEST_CASE("a motion ends early where the equations contradict each other, and says so", "[scene]") {
  build::Page page;
  const build::Named w = page.vector("\\boldsymbol{\\omega}");
  const build::Named rate = page.derivative(w, By::time);
  const auto equation = [](const build::Term& left, const build::Term& right) {
    WrittenFormChain chain;
    chain.tag = "(1)";
    chain.forms = {{left.id, "", {}}, {right.id, "", {}}};
    chain.steps.resize(1);
    chain.steps[0].kind = "=";
    return chain;
  };
  const build::Term product = build::at(w, 2) * build::at(w, 3);
  WrittenForms forms;
  forms.chains = {equation(build::at(rate, 1), product), equation(build::at(rate, 1), -(5 * product)),
                  equation(build::at(rate, 2), build::at(w, 3)), equation(build::at(rate, 3), page.zero())};
  forms.asked.push_back({"w", build::Term(w).id, {}, {}});
  forms.tree = page.tree;
  SceneFile scene;
  scene.spin = Vector3{0, 0, 1};
  scene.symbols.spin = {"w", {}, true};
  scene.motion = SceneMotion{};
  scene.motion->equations = {"(1)", {}, true};
  scene.motion->duration = 1;
  scene.asked.push_back({SceneAskKind::over_time, {"w(t)", {}}, "w"});
  const SceneResult result = evaluate_scene(scene, sample(), forms);
  REQUIRE(result.diagnostics.size() == 1);
  CHECK(result.diagnostics[0].message.find("the motion ends early: ") == 0);
  CHECK(result.diagnostics[0].message.find(": the equations contradict each other there") !=
        std::string::npos);
}

}  // namespace
}  // namespace rigor
