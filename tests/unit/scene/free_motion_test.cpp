// SPDX-License-Identifier: GPL-3.0-or-later
// The closed form of a free body's motion beside the motion that a scene integrates from the notes'
// equations.
#include "scene/motion/free_motion.h"

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

SpinRates euler_of(const Position& of) {
  return [of](const Vector3& w) {
    return Vector3{(of[1] - of[2]) / of[0] * w[1] * w[2], (of[2] - of[0]) / of[1] * w[2] * w[0],
                   (of[0] - of[1]) / of[2] * w[0] * w[1]};
  };
}

/// The law of `of` with one rate turned round.
SpinRates with_wrong_sign(const Position& of, std::size_t axis) {
  return [of, axis](const Vector3& w) {
    Vector3 rates = euler_of(of)(w);
    rates[axis] = -rates[axis];
    return rates;
  };
}

TEST_CASE("a wrong law is not taken for a free body's, however slow the spin", "[scene]") {
  for (const double size : {1e-170, 1e-163, 1e-140, 1e-100, 1., 1e90, 1e150}) {
    INFO(size);
    const MotionRequest request{
        .spin = {size, 2 * size, 3 * size}, .duration = 20 / size, .rows = 21, .tolerance = 1e-10};
    for (std::size_t axis = 0; axis < 3; ++axis)
      CHECK_FALSE(free_motion(with_wrong_sign(moments, axis), moments, request));
    const SpinRates backwards = [](const Vector3& w) {
      const Vector3 rates = free_rates(w);
      return Vector3{-rates[0], -rates[1], -rates[2]};
    };
    CHECK_FALSE(free_motion(backwards, moments, request));
    CHECK(free_motion(free_rates, moments, request).has_value() == (size >= 1e-140 && size < 1e100));
  }
}

TEST_CASE("drag that would slow a needle or a top in the duration is not a free body's", "[scene]") {
  for (const Position& of : {Position{1e-8, 1, 1}, Position{1e-8, 1, 1 + 1e-9}, Position{1, 1, 1.5}}) {
    const SpinRates free = euler_of(of);
    const MotionRequest request{.spin = {1, .2, .3}, .duration = 1e5, .rows = 21, .tolerance = 1e-9};
    CHECK(free_motion(free, of, request));
    for (const double strength : {5e-6, 1e-9, 1e-13}) {
      const SpinRates dragged = [&](const Vector3& w) {
        Vector3 rates = free(w);
        rates[0] -= strength * w[0] * std::hypot(w[0], w[1], w[2]);
        return rates;
      };
      INFO(of[0] << ' ' << strength);
      CHECK_FALSE(free_motion(dragged, of, request));
    }
  }
}

TEST_CASE("a small gap with the wrong sign is seen, at once or over a long time", "[scene]") {
  const MotionRequest once{.spin = {1, 2, 3}, .duration = 20, .rows = 21};
  CHECK_FALSE(free_motion(with_wrong_sign({1, 1 + 2e-14, 3}, 2), {1, 1 + 2e-14, 3}, once));
  CHECK(free_motion(euler_of({1, 1 + 2e-14, 3}), {1, 1 + 2e-14, 3}, once));
  const Position nearly{1, 1 + 1e-15, 3};
  const MotionRequest longer{.spin = {1, 2, 3}, .duration = 1e7, .rows = 21};
  CHECK_FALSE(free_motion(with_wrong_sign(nearly, 2), nearly, longer));
  CHECK(free_motion(euler_of(nearly), nearly, longer));
}

TEST_CASE("a torque only where the path crosses a plane is seen", "[scene]") {
  const SpinRates kicked = [](const Vector3& w) {
    Vector3 rates = free_rates(w);
    rates[0] -= 5 * w[0] / std::pow(1 + std::pow(w[1] / .001, 2), 5);
    return rates;
  };
  for (const double duration : {20., -20., 1e4})
    CHECK_FALSE(free_motion(kicked, moments, {.spin = {1, 2, 3}, .duration = duration, .rows = 3}));
}

TEST_CASE("what has no number for a row is integrated", "[scene]") {
  MotionRequest request{
      .spin = {1, 2, 3}, .duration = 1e14, .rows = 3, .orientation = Quaternion{1, 0, 0, 0}};
  CHECK(free_motion(free_rates, moments, request));
  for (const double duration : {1e16, 1e25, 1e308, std::nan("")}) {
    request.duration = duration;
    CHECK_FALSE(free_motion(free_rates, moments, request));
  }
  const Position needle{1e-38, 1, 1.5};
  CHECK_FALSE(free_motion(euler_of(needle), needle, {.spin = {.3, .4, .5}, .duration = .1, .rows = 3}));
  request.duration = 20;
  request.tolerance = 1e-17;
  CHECK_FALSE(free_motion(free_rates, moments, request));
}

TEST_CASE("moments whose gap is in their low parts do not move by the high ones", "[scene]") {
  const auto suffices = [&](double gap, double low, double duration) {
    const SharpPosition sharp{{{1, 0}, {1 + gap, low}, {3, 0}}};
    return high_parts_suffice(sharp, {.spin = {1, 2, 3}, .duration = duration});
  };
  CHECK(suffices(1, 1e-16, 1e9));
  CHECK(suffices(0, 0, 1e9));
  CHECK(suffices(1e-13, 1e-16, 20));
  CHECK_FALSE(suffices(1e-13, 1e-16, -1e9));
  CHECK_FALSE(suffices(0, 1e-17, 1e9));
}

TEST_CASE("about the middle axis the least torque is no free body's", "[scene]") {
  const MotionRequest request{.spin = {0, 5, 0}, .duration = 20, .rows = 5};
  CHECK(free_motion(free_rates, moments, request));
  const auto pushed = [](const Vector3& w) {
    Vector3 rates = free_rates(w);
    rates[0] += 1e-18;
    return rates;
  };
  CHECK_FALSE(free_motion(pushed, moments, request));
}

}  // namespace
}  // namespace rigor
