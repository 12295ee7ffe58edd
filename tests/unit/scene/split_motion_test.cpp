// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/motion/split_motion.h"

#include <cmath>
#include <limits>

#include "catch.h"
#include "numeric/kernels/torque_free.h"
#include "numeric/kernels/torque_free_attitude.h"
#include "scene/played_scene.h"

namespace rigor {
namespace {

constexpr Position moments{1, 2, 2.5};
constexpr Vector3 wheel{.3, .5, -.2};

/// Of a body with a wheel, dL/dt = (L + h) × ω: it keeps T and |L + h|.
Vector3 wheel_rates(const Vector3& w) {
  Vector3 rates = free_spin_rates(moments, w);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    rates[i] += (wheel[j] * w[k] - wheel[k] * w[j]) / moments[i];
  }
  return rates;
}

MotionRequest request_of(double duration, std::size_t rows) {
  return {
      .spin = {.6, .7, .9}, .duration = duration, .rows = rows, .orientation = Quaternion{.5, .5, .5, .5}};
}

struct Swing {
  double energy = 0;
  double momentum = 0;  // |L + h|²
};
/// The greatest distances from the first values.
Swing swing_of(const Motion& motion) {
  Swing swing;
  Swing first;
  for (std::size_t row = 0; row < motion.spins.size(); ++row) {
    Swing now;
    for (std::size_t i = 0; i < 3; ++i) {
      const double w = motion.spins[row][i];
      now.energy += moments[i] * w * w;
      now.momentum += std::pow(moments[i] * w + wheel[i], 2);
    }
    if (row == 0) first = now;
    swing.energy = std::max(swing.energy, std::abs(now.energy - first.energy));
    swing.momentum = std::max(swing.momentum, std::abs(now.momentum - first.momentum));
  }
  return swing;
}

TEST_CASE("split steps are of order 2", "[motion]") {
  const Motion motion = split_motion(wheel_rates, moments, request_of(20, 101), 2);
  REQUIRE(motion.split_order);
  CHECK(*motion.split_order == Approx(2).margin(.05));
  CHECK(motion.steps == 200);
  MotionRequest exact = request_of(20, 101);
  exact.tolerance = 1e-13;
  const Motion smooth = integrate(wheel_rates, exact);
  for (const std::size_t split : {4, 8}) {
    const Motion coarse = split_motion(wheel_rates, moments, request_of(20, 101), split);
    const Motion fine = split_motion(wheel_rates, moments, request_of(20, 101), 2 * split);
    for (std::size_t i = 0; i < 4; ++i) {
      const double error = coarse.orientations[100][i] - smooth.orientations[100][i];
      const double next = fine.orientations[100][i] - smooth.orientations[100][i];
      CHECK(error / next == Approx(4).epsilon(.05));
    }
  }
}

TEST_CASE("what split steps keep swings, and does not run away", "[motion]") {
  const Swing once = swing_of(split_motion(wheel_rates, moments, request_of(100, 501), 1));
  const Swing longer = swing_of(split_motion(wheel_rates, moments, request_of(1000, 5001), 1));
  const Swing finer = swing_of(split_motion(wheel_rates, moments, request_of(100, 501), 2));
  CHECK(once.momentum > 1e-5);
  CHECK(longer.momentum < 1.2 * once.momentum);
  CHECK(finer.momentum == Approx(once.momentum / 4).epsilon(.1));
  CHECK(longer.energy < 1e-12);  // both parts keep it
}

TEST_CASE("a body without a torque moves exactly in split steps", "[motion]") {
  const auto free = [](const Vector3& w) { return Vector3(free_spin_rates(moments, w)); };
  const Motion motion = split_motion(free, moments, request_of(20, 3), 7);
  CHECK_FALSE(motion.split_order);
  const Position spin = TorqueFree::make(moments, {.6, .7, .9})->spin(20);
  const Quaternion turn = composed({.5, .5, .5, .5}, TorqueFreeAttitude::make(moments, {.6, .7, .9})->at(20));
  double along = 0;
  for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(motion.spins[2][i] - spin[i]) < 1e-14);
  for (std::size_t i = 0; i < 4; ++i) along += motion.orientations[2][i] * turn[i];
  CHECK(std::abs(std::abs(along) - 1) < 1e-14);
}

TEST_CASE("split steps go back as they came", "[motion]") {
  const Motion there = split_motion(wheel_rates, moments, request_of(30, 2), 60);
  MotionRequest back = request_of(-30, 2);
  back.spin = there.spins[1];
  back.orientation = there.orientations[1];
  const Motion home = split_motion(wheel_rates, moments, back, 60);
  for (std::size_t i = 0; i < 3; ++i)
    CHECK(home.spins[1][i] == Approx(request_of(30, 2).spin[i]).epsilon(1e-11));
  for (const double part : home.orientations[1]) CHECK(std::abs(part) == Approx(.5).epsilon(1e-11));
}

TEST_CASE("split steps end where there are no rates, and after too much work", "[motion]") {
  const auto lost = [](const Vector3&) { return Vector3{std::nan(""), 0, 0}; };
  const Motion motion = split_motion(lost, moments, request_of(20, 3), 1);
  CHECK(motion.stopped.find("the spin or its rates are not finite after 0 s") == 0);
  MotionRequest little = request_of(20, 101);
  little.most_evaluations = 500;
  CHECK(split_motion(wheel_rates, moments, little, 1).stopped.find("500 evaluations of the rates") == 0);
}

TEST_CASE("the scene of a body with a wheel shows order 2 and no drift", "[scene]") {
  const Played scene("derivations/scenes/wheel.toml");
  CHECK(scene.messages() == "");
  REQUIRE(scene.result.motion);
  REQUIRE(scene.result.motion->split_order);
  CHECK(*scene.result.motion->split_order == Approx(2).margin(.1));
  CHECK(scene.result.motion->steps == 2000);
  REQUIRE(scene.result.drifts.size() == 3);
  CHECK(scene.result.drifts[0].relative < 1e-12);
  CHECK(scene.result.drifts[1].relative > 1e-5);
  CHECK(scene.result.drifts[1].relative < 1e-3);
}

TEST_CASE("steps without an error have no order", "[motion]") {
  const auto pushed = [](const Vector3&) { return Vector3{.165, 0, 0}; };
  for (const std::size_t split : {1, 2, 4}) {
    MotionRequest request = request_of(1, 4);
    request.spin = {};
    CHECK_FALSE(split_motion(pushed, moments, request, split).split_order);
  }
  const auto free = [](const Vector3& w) { return Vector3{free_spin_rates(moments, w)}; };
  const Motion motion = split_motion(free, moments, request_of(1e5, 11), 10);
  CHECK_FALSE(motion.split_order);
  const Position exact = TorqueFree::make(moments, {.6, .7, .9})->spin(1e5);
  for (std::size_t i = 0; i < 3; ++i) CHECK(motion.spins.back()[i] == Approx(exact[i]).margin(1e-10));
}

TEST_CASE("kicks that take too long end the motion with the reason", "[motion]") {
  MotionRequest request = request_of(1e6, 2);
  request.most_evaluations = 10'000;
  const Motion motion = split_motion(wheel_rates, moments, request, 1000);
  CHECK(motion.stopped.find("evaluations of the rates are not enough") != std::string::npos);
  CHECK(motion.evaluations < 20'000);
}

}  // namespace
}  // namespace rigor
