// SPDX-License-Identifier: GPL-3.0-or-later
// What holds of a free spin at every time: each component is good to 16 u of itself and what it changes in
// 2^-62 of a period and 2^-93 of the time.
#include <cmath>

#include "base/splitmix.h"
#include "catch.h"
#include "numeric/climb.h"
#include "numeric/kernels/free_motion_reference.h"
#include "numeric/kernels/torque_free.h"

namespace rigor {
namespace {

constexpr double component_bound = 16 * 0x1p-53;

struct SpunBody {
  Position moments{};
  Position spin{};
};

struct WorstComponent {
  double beside_itself = 0;  // in units of 16 u of the component
  double beside_bound = 0;
};

WorstComponent worst_component(const SpunBody& body, const Digits70& period, double time) {
  const auto motion = TorqueFree::make(body.moments, body.spin);
  REQUIRE(motion);
  const Digits70 rest = Digits70(time) - period * floor(Digits70(time) / period);
  const ReferenceMotion exact = moved(body.moments, at_rest_of(body.spin), rest);
  const Position found = motion->spin(time);
  const Digits70 near = period * Digits70(0x1p-62) + Digits70(0x1p-93) * std::abs(time);
  WorstComponent worst;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const Digits70 factor = (Digits70(body.moments[j]) - body.moments[k]) / body.moments[i];
    const Digits70 change = abs(factor * exact.spin[j] * exact.spin[k]) * near;
    const Digits70 error = abs(found[i] - exact.spin[i]);
    if (error == 0) continue;
    const Digits70 own = component_bound * abs(exact.spin[i]);
    INFO(time << " s, component " << i << ": " << found[i]);
    CHECK(error <= own + change);
    worst.beside_itself = std::max(worst.beside_itself, static_cast<double>(Digits70(error / own)));
    worst.beside_bound = std::max(worst.beside_bound, static_cast<double>(Digits70(error / (own + change))));
  }
  return worst;
}

/// Times next to each other between which the component passes through 0, from `from` on.
std::array<double, 2> zero_of(const TorqueFree& motion, std::size_t component, double from, double step) {
  double low = from;
  while (motion.spin(low)[component] * motion.spin(low + step)[component] > 0) low += step;
  double high = low + step;
  for (;;) {
    const double middle = low / 2 + high / 2;
    if (middle <= low || middle >= high) return {low, high};
    (motion.spin(low)[component] * motion.spin(middle)[component] > 0 ? low : high) = middle;
  }
}

TEST_CASE("where a component passes through 0 the spin is right for a time that is very near") {
  double worst = 0;
  for (const SpunBody& body :
       {SpunBody{{1, 2, 2.5}, {.6, .7, .9}}, SpunBody{{3, 2, 1}, {.1, 1, -.2}},
        SpunBody{{1, 5, 9}, {3, 1, 1 + 1e-3}}, SpunBody{{1e-3, 1, 1.0005}, {.6, -.7, .2}},
        SpunBody{{1, 1.3, 2.2}, {1e-3, 2e-3, 1}}}) {
    const Digits70 period = period_of(body.moments, body.spin);
    const auto motion = TorqueFree::make(body.moments, body.spin);
    REQUIRE(motion);
    const auto turn = static_cast<double>(period);
    for (const double count : {0., -1e6, 0x1p45}) {
      for (std::size_t i = 0; i < 3; ++i) {
        bool passes = false;
        for (int k = 0; k < 16; ++k)
          passes = passes || motion->spin(turn * k / 16)[i] * motion->spin(0)[i] < 0;
        if (!passes) continue;
        for (const double time : zero_of(*motion, i, turn * count, turn / 64))
          worst = std::max(worst, worst_component(body, period, time).beside_itself);
      }
    }
  }
  CHECK(worst > 2);  // 16 u of the component alone does not hold
}

TEST_CASE("after any number of periods the spin is right for a time that is very near", "[torque free]") {
  SplitMix random(23);
  const auto number = [&] { return std::ldexp(static_cast<double>(random.next() >> 11), -53); };
  for (int k = 0; k < 60; ++k) {
    const SpunBody body{{1 + number(), 2 + number(), 3 + number()}, {number(), .1 + number(), number()}};
    const Digits70 period = period_of(body.moments, body.spin);
    CHECK(
        worst_component(body, period, static_cast<double>(period) * std::exp2(46 * number())).beside_bound <=
        1);
  }
}

TEST_CASE("climbing for the worst error of a spin ends below its bound", "[torque free]") {
  SplitMix random(24);
  const auto number = [&] { return std::ldexp(static_cast<double>(random.next() >> 11), -53); };
  struct SpinAt {
    SpunBody body;
    double periods = 0;
  };
  const auto changed = [&](SpinAt at) {
    const std::size_t i = random.below(3);
    switch (random.below(4)) {
      case 0:
        at.body.moments[i] = std::exp2(4 * number());
        break;
      case 1:
        at.body.spin[i] = (2 * number() - 1) * std::pow(10, -4 * number());
        break;
      case 2:
        at.periods = (2 * number() - 1) * std::exp2(46 * number());
        break;
      default:
        at.periods *= 1 + number() * 0x1p-20;
    }
    return at;
  };
  const auto badness = [](const SpinAt& at) {
    const auto& [i1, i2, i3] = at.body.moments;
    if (i1 == i2 || i2 == i3 || i3 == i1) return 0.0;
    const Digits70 period = period_of(at.body.moments, at.body.spin);
    return worst_component(at.body, period, static_cast<double>(period) * at.periods).beside_bound;
  };
  const double worst = climbed(SpinAt{{{1, 2, 2.5}, {.6, .7, .9}}, 0.3}, 150, changed, badness);
  CHECK(worst <= 1);
  CHECK(worst > 0.1);  // so that the bound says something
}

}  // namespace
}  // namespace rigor
