// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/kernels/torque_free_step.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "base/splitmix.h"
#include "catch.h"
#include "numeric/climb.h"
#include "numeric/kernels/free_motion_reference.h"
#include "numeric/kernels/torque_free.h"
#include "numeric/kernels/torque_free_attitude.h"

namespace rigor {
namespace {

constexpr double unit = 0x1p-53;
constexpr double spin_bound = 16 * unit;     // of a component and of its first change in the step
constexpr double attitude_bound = 8 * unit;  // of |q − q'|
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct StepCase {
  Position moments{};
  Position spin{};
  double time = 0;
  AttitudeQuaternion attitude{1, 0, 0, 0};
};

/// Columns of bodies, as the kernel takes them.
class FreeColumns {
 public:
  explicit FreeColumns(const std::vector<StepCase>& cases) {
    for (std::vector<double>& column : columns_) column.reserve(cases.size());
    for (const StepCase& body : cases) {
      for (std::size_t i = 0; i < 3; ++i) columns_[i].push_back(body.moments[i]);
      for (std::size_t i = 0; i < 3; ++i) columns_[3 + i].push_back(body.spin[i]);
      for (std::size_t i = 0; i < 4; ++i) columns_[6 + i].push_back(body.attitude[i]);
      columns_[10].push_back(body.time);
    }
  }
  [[nodiscard]] FreeBodies bodies() {
    FreeBodies all{.count = columns_[0].size(), .times = columns_[10].data()};
    for (std::size_t i = 0; i < 3; ++i) all.moments[i] = columns_[i].data();
    for (std::size_t i = 0; i < 3; ++i) all.spin[i] = columns_[3 + i].data();
    for (std::size_t i = 0; i < 4; ++i) all.attitude[i] = columns_[6 + i].data();
    return all;
  }
  [[nodiscard]] StepCase at(std::size_t body) const {
    StepCase found{.time = columns_[10][body]};
    for (std::size_t i = 0; i < 3; ++i) found.moments[i] = columns_[i][body];
    for (std::size_t i = 0; i < 3; ++i) found.spin[i] = columns_[3 + i][body];
    for (std::size_t i = 0; i < 4; ++i) found.attitude[i] = columns_[6 + i][body];
    return found;
  }

 private:
  std::array<std::vector<double>, 11> columns_;
};

StepCase stepped(const StepCase& body) {
  FreeColumns columns({body});
  step_free_bodies(columns.bodies());
  return columns.at(0);
}

/// By the lanes, not by the closed form for all times.
bool is_short(const StepCase& body) {
  FreeColumns columns({body});
  std::size_t beyond = 0;
  return lane_kernels().step_free_bodies(columns.bodies(), &beyond) == 0;
}

std::array<Digits70, 4> product_of(const AttitudeQuaternion& q, const std::array<Digits70, 4>& r) {
  std::array<Digits70, 4> product{q[0] * r[0] - q[1] * r[1] - q[2] * r[2] - q[3] * r[3]};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    product[1 + i] = q[0] * r[1 + i] + q[1 + i] * r[0] + q[1 + j] * r[1 + k] - q[1 + k] * r[1 + j];
  }
  Digits70 square = 0;
  for (const Digits70& part : product) square += part * part;
  for (Digits70& part : product) part /= sqrt(square);
  return product;
}

/// Errors over their bounds.
struct StepErrors {
  double spin = 0;
  double attitude = 0;
  [[nodiscard]] double worst() const { return std::max(spin, attitude); }
};
StepErrors errors_of(const StepCase& body, const StepCase& found) {
  StepErrors errors;
  const ReferenceMotion exact = moved(body.moments, at_rest_of(body.spin), body.time, true);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const Digits70 factor = (Digits70(body.moments[j]) - body.moments[k]) / body.moments[i];
    const Digits70 scale =
        std::abs(body.spin[i]) + abs(factor * body.spin[j] * body.spin[k] * Digits70(body.time));
    const Digits70 error = abs(found.spin[i] - exact.spin[i]);
    if (error != 0) errors.spin = std::max(errors.spin, static_cast<double>(Digits70(error / scale)));
  }
  const auto turn = product_of(body.attitude, exact.turn);
  Digits70 along = 0;
  for (std::size_t i = 0; i < 4; ++i) along += turn[i] * found.attitude[i];
  Digits70 square = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Digits70 error = (along < 0 ? Digits70(-turn[i]) : turn[i]) - found.attitude[i];
    square += error * error;
  }
  errors.attitude = static_cast<double>(sqrt(square));
  return {errors.spin / spin_bound, errors.attitude / attitude_bound};
}

double draw(SplitMix& random) { return std::ldexp(static_cast<double>(random.next() >> 11), -53); }

/// Of a body that can exist, as unlike as 10^-`digits`, and a step of |ω| t < 0.7.
StepCase drawn(SplitMix& random, double digits) {
  StepCase body;
  Position parts{};
  for (double& part : parts) part = std::pow(10, -digits * draw(random));
  for (std::size_t i = 0; i < 3; ++i) body.moments[i] = parts[(i + 1) % 3] + parts[(i + 2) % 3];
  for (double& each : body.spin) each = (2 * draw(random) - 1) * std::pow(10, -digits * draw(random));
  body.time = (1.4 * draw(random) - .7) / std::hypot(body.spin[0], body.spin[1], body.spin[2]);
  double square = 0;
  for (double& each : body.attitude) each = 2 * draw(random) - 1;
  for (const double each : body.attitude) square += each * each;
  for (double& each : body.attitude) each /= std::sqrt(square);
  return body;
}

TEST_CASE("no climb finds a step that errs by more than it says", "[torque free]") {
  SplitMix random(18);
  const auto changed = [&](StepCase body) {
    const double factor = 1 + std::pow(10, -12 * draw(random)) * (2 * draw(random) - 1);
    const std::size_t at = random.below(11);
    if (at < 3) body.moments[at] *= factor;
    if (at >= 3 && at < 6) body.spin[at - 3] *= factor;
    if (at == 6) body.time *= factor;
    if (at > 6) body.attitude[at - 7] *= factor;
    return body;
  };
  StepErrors worst;
  for (int start = 0; start < 16; ++start) {
    const StepCase body = drawn(random, std::array{.3, 1., 4., 12.}[start % 4]);
    worst.spin = std::max(worst.spin, climbed(body, 25, changed, [](const StepCase& each) {
                            return is_short(each) ? errors_of(each, stepped(each)).spin : 0;
                          }));
    worst.attitude = std::max(worst.attitude, climbed(body, 25, changed, [](const StepCase& each) {
                                return is_short(each) ? errors_of(each, stepped(each)).attitude : 0;
                              }));
  }
  CHECK(worst.spin < 1);
  CHECK(worst.spin > .2);
  CHECK(worst.attitude < 1);
  CHECK(worst.attitude > .2);
}

TEST_CASE("every step up to 0.7 rad is taken in lanes", "[torque free]") {
  SplitMix random(7);
  for (int k = 0; k < 2000; ++k) CHECK(is_short(drawn(random, k % 13)));
  const double slack = 0x1p-40;
  CHECK(is_short({{slack, 1, 1 + slack}, {0, 1, 0}, .707}));
  CHECK_FALSE(is_short({{slack, 1, 1 + slack}, {0, 1, 0}, .708}));
}

TEST_CASE("a step of tops, spheres, needles, plates and steady spins is right", "[torque free]") {
  for (const Position& moments :
       {Position{1, 1, 2}, Position{2, 1, 1}, Position{1, 2, 1}, Position{1, 2, 2}, Position{1, 1 + 1e-12, 2},
        Position{1, 1, 1}, Position{3, 1, 2}, Position{1e-9, 1, 1 + 1e-9}, Position{1, 1e-60, 1}}) {
    for (const Position& spin : {Position{.3, .2, .4}, Position{.3, 1e-9, 1e-300}, Position{0, .5, 0},
                                 Position{1e-200, 0, .5}, Position{-.4, .1, 0}}) {
      INFO(moments[0] << " " << moments[1] << " " << moments[2] << ", " << spin[0] << " " << spin[1]);
      CHECK(errors_of({moments, spin, 1}, stepped({moments, spin, 1})).worst() < 1);
      CHECK(errors_of({moments, spin, -1e-3}, stepped({moments, spin, -1e-3})).worst() < 1);
    }
  }
}

TEST_CASE("a step on the separatrix and next to the middle axis is right", "[torque free]") {
  for (const double off : {0., 1e-12, -1e-4}) {
    const StepCase body{{1, 5, 9}, {.3, .1, .1 + off}, 2};
    CHECK(errors_of(body, stepped(body)).worst() < 1);
  }
  for (const double off : {1e-3, 1e-16, 1e-100}) {
    const StepCase body{{1, 2, 3}, {off, .7, -off / 2}, 1};
    CHECK(errors_of(body, stepped(body)).worst() < 1);
  }
}

TEST_CASE("nothing turns without spin or without time", "[torque free]") {
  const StepCase rest = stepped({{1, 2, 2.5}, {0, 0, 0}, 1, {.5, .5, .5, .5}});
  CHECK(rest.spin == Position{0, 0, 0});
  CHECK(rest.attitude == AttitudeQuaternion{.5, .5, .5, .5});
  const StepCase at_once = stepped({{1, 2, 2.5}, {.6, .7, .9}, 0, {.5, .5, .5, .5}});
  CHECK(at_once.spin == Position{.6, .7, .9});
  CHECK(at_once.attitude == AttitudeQuaternion{.5, .5, .5, .5});
}

TEST_CASE("a step is the same in every unit of time and of mass", "[torque free]") {
  const StepCase plain = stepped({{1, 2, 2.5}, {.3, .2, .4}, 1});
  for (const int power : {-1020, -900, -510, 500, 900, 1000}) {
    const double faster = std::ldexp(1, power);
    const double heavier = std::ldexp(1, power / 2);
    const StepCase found = stepped({{heavier, 2 * heavier, 2.5 * heavier},
                                    {.3 * faster, .2 * faster, .4 * faster},
                                    std::ldexp(1, -power)});
    INFO(power);
    CHECK(found.attitude == plain.attitude);
    if (power > -1000)
      for (std::size_t i = 0; i < 3; ++i) CHECK(found.spin[i] == plain.spin[i] * faster);
  }
}

TEST_CASE("longer steps are those of the closed form for all times", "[torque free]") {
  for (const double time : {2., -5., 1e3, 1e9}) {
    const StepCase body{{1, 2, 2.5}, {.6, .7, .9}, time};
    REQUIRE_FALSE(is_short(body));
    const StepCase found = stepped(body);
    CHECK(found.spin == TorqueFree::make(body.moments, body.spin)->spin(time));
    const auto turn = TorqueFreeAttitude::make(body.moments, body.spin)->at(time);
    for (std::size_t i = 0; i < 4; ++i) CHECK(std::abs(found.attitude[i] - turn[i]) < attitude_bound);
  }
}

TEST_CASE("bodies without a motion become not a number, alone", "[torque free]") {
  const double infinity = std::numeric_limits<double>::infinity();
  const StepCase good{{1, 2, 2.5}, {.3, .2, .4}, 1};
  std::vector<StepCase> cases;
  const std::vector<StepCase> bad{{{0, 1, 1}, {.3, .2, .4}, 1},     {{-1, 2, 2}, {.3, .2, .4}, 1},
                                  {{1, nan, 2}, {.3, .2, .4}, 1},   {{1, 2, infinity}, {.3, .2, .4}, 1},
                                  {{1, 2, 3}, {nan, .2, .4}, 1},    {{1, 2, 3}, {.3, -infinity, .4}, 1},
                                  {{1, 2, 3}, {.3, .2, .4}, nan},   {{1, 2, 3}, {.3, .2, .4}, infinity},
                                  {{1, 2, 3}, {.3, .2, .4}, 1e200}, {{1e-100, 1, 1e100}, {.3, .2, .4}, 1}};
  for (const StepCase& each : bad) {
    cases.push_back(good);
    cases.push_back(each);
  }
  FreeColumns columns(cases);
  CHECK(step_free_bodies(columns.bodies()) == bad.size());
  const StepCase expected = stepped(good);
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const StepCase found = columns.at(k);
    INFO(k);
    if (k % 2 == 0) {
      CHECK(found.spin == expected.spin);
      CHECK(found.attitude == expected.attitude);
    } else {
      for (const double each : found.spin) CHECK(std::isnan(each));
      for (const double each : found.attitude) CHECK(std::isnan(each));
    }
  }
}

TEST_CASE("a step has the same bits at every place and in every instruction set", "[torque free]") {
  SplitMix random(3);
  std::vector<StepCase> cases(2051);
  for (std::size_t k = 0; k < cases.size(); ++k) cases[k] = drawn(random, static_cast<double>(k % 9));
  for (std::size_t k = 0; k < cases.size(); k += 97) cases[k].time *= 40;
  for (const LaneKernels* kernels : runnable_lane_kernels()) {
    INFO(kernels->instruction_set);
    FreeColumns columns(cases);
    CHECK(step_free_bodies(columns.bodies(), *kernels) == 0);
    std::size_t others = 0;
    for (std::size_t k = 0; k < cases.size(); ++k) {
      const StepCase found = columns.at(k);
      const StepCase one = stepped(cases[k]);
      if (std::memcmp(found.spin.data(), one.spin.data(), sizeof one.spin) != 0 ||
          std::memcmp(found.attitude.data(), one.attitude.data(), sizeof one.attitude) != 0)
        ++others;
    }
    CHECK(others == 0);
  }
}

TEST_CASE("all bodies may move for the same time", "[torque free]") {
  std::vector<StepCase> cases(9, {{1, 2, 2.5}, {.3, .2, .4}, .5});
  FreeColumns each(cases);
  FreeColumns common(cases);
  step_free_bodies(each.bodies());
  FreeBodies bodies = common.bodies();
  bodies.times = nullptr;
  bodies.time = .5;
  step_free_bodies(bodies);
  for (std::size_t k = 0; k < cases.size(); ++k) CHECK(common.at(k).spin == each.at(k).spin);
}

/// Components of angular momentum along axes at rest.
Position momentum_in_space(const StepCase& body) {
  const auto& [w, x, y, z] = body.attitude;
  Position l{};
  for (std::size_t i = 0; i < 3; ++i) l[i] = body.moments[i] * body.spin[i];
  const Position once{2 * (y * l[2] - z * l[1]), 2 * (z * l[0] - x * l[2]), 2 * (x * l[1] - y * l[0])};
  return {l[0] + w * once[0] + y * once[2] - z * once[1], l[1] + w * once[1] + z * once[0] - x * once[2],
          l[2] + w * once[2] + x * once[1] - y * once[0]};
}

TEST_CASE("momentum in space and energy drift over 1e5 steps by no more than roundings do", "[torque free]") {
  constexpr std::size_t steps = 100'000;
  SplitMix random(5);
  std::vector<StepCase> cases(16);
  for (StepCase& body : cases) body = drawn(random, 1);
  FreeColumns columns(cases);
  for (std::size_t k = 0; k < steps; ++k) step_free_bodies(columns.bodies());
  double worst = 0;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const Position before = momentum_in_space(cases[k]);
    const StepCase end = columns.at(k);
    const Position after = momentum_in_space(end);
    double energy = 0;
    double change = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      energy += end.moments[i] * cases[k].spin[i] * cases[k].spin[i];
      change += end.moments[i] * (end.spin[i] * end.spin[i] - cases[k].spin[i] * cases[k].spin[i]);
    }
    worst = std::max(worst, std::abs(change) / energy);
    const double size = std::hypot(before[0], before[1], before[2]);
    for (std::size_t i = 0; i < 3; ++i) worst = std::max(worst, std::abs(after[i] - before[i]) / size);
  }
  CHECK(worst < 64 * unit * std::sqrt(steps));
}

}  // namespace
}  // namespace rigor
