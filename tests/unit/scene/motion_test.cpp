// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/motion/motion.h"

#include <cmath>
#include <limits>

#include "catch.h"

namespace rigor {
namespace {

/// A body without torque, for tests: the notes' equations are tested where the notes are read.
SpinRates free_body(Vector3 moments) {
  return [moments](const Vector3& w) {
    Vector3 rates{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      rates[i] = (moments[j] - moments[k]) / moments[i] * w[j] * w[k];
    }
    return rates;
  };
}

/// A symmetric top about its third axis: ω₁ and ω₂ go round with Ω = (I₃ − I₁)/I₁ ω₃.
double top_error(double tolerance) {
  const double rate = (3.0 - 2.0) / 2.0 * 4.0;
  const Motion motion = integrate(free_body({2, 2, 3}),
                                  {.spin = {0.5, 0, 4}, .duration = 20, .rows = 3, .tolerance = tolerance});
  double worst = 0;
  for (std::size_t row = 0; row < motion.times.size(); ++row) {
    const double angle = rate * motion.times[row];
    worst = std::max({worst, std::abs(motion.spins[row][0] - 0.5 * std::cos(angle)),
                      std::abs(motion.spins[row][1] - 0.5 * std::sin(angle))});
  }
  return worst;
}

TEST_CASE("a symmetric top's spin goes round in a circle, as its formula says", "[motion]") {
  CHECK(top_error(1e-10) < 1e-8);
  CHECK(top_error(1e-13) < 1e-11);
  CHECK(top_error(1e-3) > 1e-8);  // the tolerance matters
}

TEST_CASE("a motion has the rows that were asked for, the last one at the duration", "[motion]") {
  const Motion motion =
      integrate(free_body({1, 2, 2.5}), {.spin = {.6, .7, .9}, .duration = 100, .rows = 11});
  REQUIRE(motion.times.size() == 11);
  CHECK(motion.spins.size() == 11);
  CHECK(motion.orientations.empty());
  CHECK(motion.times.front() == 0);
  CHECK(motion.times[5] == 50);
  CHECK(motion.times.back() == 100);
  CHECK(motion.stopped.empty());
}

TEST_CASE("forwards and then backwards a motion comes back to its start", "[motion]") {
  const SpinRates rates = free_body({1, 2, 2.5});
  const Motion there =
      integrate(rates, {.spin = {.6, .7, .9}, .duration = 100, .rows = 2, .tolerance = 1e-13});
  const Motion back =
      integrate(rates, {.spin = there.spins.back(), .duration = -100, .rows = 2, .tolerance = 1e-13});
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(std::abs(back.spins.back()[i] - Vector3{.6, .7, .9}[i]) < 1e-10);
  }
  CHECK(std::abs(there.spins.back()[0] - .6) > 1e-3);
}

TEST_CASE("the result does not depend on the unit of time", "[motion]") {
  const SpinRates rates = free_body({1, 2, 2.5});
  const Motion slow = integrate(rates, {.spin = {.6, .7, .9}, .duration = 100});
  const double factor = 0x1p40;
  const Motion fast =
      integrate(rates, {.spin = {.6 * factor, .7 * factor, .9 * factor}, .duration = 100 / factor});
  REQUIRE(slow.spins.size() == fast.spins.size());
  for (std::size_t row = 0; row < slow.spins.size(); ++row)
    CHECK(slow.spins[row][1] * factor == fast.spins[row][1]);
}

TEST_CASE("the angular momentum of a free body rests in space", "[motion]") {
  const Vector3 moments{1, 2, 2.5};
  const Motion motion = integrate(
      free_body(moments),
      {.spin = {.6, .7, .9}, .duration = 100, .tolerance = 1e-12, .orientation = Quaternion{1, 0, 0, 0}});
  REQUIRE(motion.orientations.size() == motion.spins.size());
  for (std::size_t row = 0; row < motion.spins.size(); ++row) {
    Vector3 momentum{};
    for (std::size_t i = 0; i < 3; ++i) momentum[i] = moments[i] * motion.spins[row][i];
    const Vector3 in_space = turned(motion.orientations[row], momentum);
    CHECK(std::abs(in_space[0] - .6) < 1e-9);
    CHECK(std::abs(in_space[1] - 1.4) < 1e-9);
    CHECK(std::abs(in_space[2] - 2.25) < 1e-9);
  }
}

TEST_CASE("a steady spin about an axis turns the body by its angle", "[motion]") {
  const Motion motion =
      integrate([](const Vector3&) { return Vector3{}; },
                {.spin = {0, 0, 2}, .duration = 0.5, .orientation = Quaternion{1, 0, 0, 0}});
  const Vector3 x = turned(motion.orientations.back(), {1, 0, 0});
  CHECK(std::abs(x[0] - std::cos(1.0)) < 1e-10);
  CHECK(std::abs(x[1] - std::sin(1.0)) < 1e-10);
}

TEST_CASE("a body at rest stays at rest, and one that is driven starts", "[motion]") {
  CHECK(integrate(free_body({1, 2, 3}), {.duration = 10}).spins.back() == Vector3{0, 0, 0});
  const Motion driven = integrate([](const Vector3&) { return Vector3{2, 0, 0}; }, {.duration = 10});
  CHECK(std::abs(driven.spins.back()[0] - 20) < 1e-9);
}

TEST_CASE("a motion that runs away stops, with its rows until then and the time", "[motion]") {
  // dω/dt = ω² from 1 is infinite at the time 1.
  const Motion motion = integrate(
      [](const Vector3& w) {
        return Vector3{w[0] * w[0], 0, 0};
      },
      {.spin = {1, 0, 0}, .duration = 2});
  CHECK(!motion.stopped.empty());
  CHECK(motion.times.size() == motion.spins.size());
  CHECK(motion.times.back() < 1.01);
  CHECK(motion.times.back() > 0.9);
  CHECK(motion.stopped.find(" s") != std::string::npos);
}

TEST_CASE("a motion that would take too long stops at its bound", "[motion]") {
  const Motion motion =
      integrate(free_body({1, 2, 2.5}),
                {.spin = {.6, .7, .9}, .duration = 1e12, .rows = 3, .most_evaluations = 10'000});
  CHECK(motion.stopped.find("10000 evaluations of the rates are not enough after ") == 0);
  CHECK(motion.evaluations < 10'100);
}

TEST_CASE("rates that are not a number stop the motion", "[motion]") {
  const Motion motion = integrate(
      [](const Vector3&) {
        return Vector3{std::nan(""), 0, 0};
      },
      {.spin = {1, 0, 0}, .duration = 1});
  CHECK(motion.stopped == "the spin or its rates are not finite after 0 s");
  CHECK(motion.times.size() == 1);
}

TEST_CASE("what cannot be integrated is refused with its reason", "[motion]") {
  const SpinRates rates = free_body({1, 2, 3});
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(integrate(rates, {.spin = {infinity, 0, 0}, .duration = 1}).stopped == "the spin is not finite");
  CHECK(integrate(rates, {.spin = {1, 0, 0}, .duration = infinity}).stopped == "the duration is not finite");
  CHECK(integrate(rates, {.duration = 1, .rows = 0}).stopped == "no row was asked for");
  CHECK(integrate(rates, {.duration = 1, .tolerance = 1e-17}).stopped ==
        "the tolerance 1e-17 is not between 1e-15 and 0.01");
}

}  // namespace
}  // namespace rigor
