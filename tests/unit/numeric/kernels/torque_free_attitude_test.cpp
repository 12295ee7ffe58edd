// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/kernels/torque_free_attitude.h"

#include <cmath>
#include <cstring>
#include <limits>

#include "catch.h"
#include "numeric/kernels/free_motion_reference.h"
#include "numeric/kernels/torque_free.h"
#include "numeric/lane/lane_kernels.h"

namespace rigor {
namespace {

constexpr double bound = 16 * 0x1p-53;  // of |q − q'|

double distance(const AttitudeQuaternion& found, const std::array<Digits70, 4>& reference) {
  Digits70 along = 0;
  for (std::size_t i = 0; i < 4; ++i) along += found[i] * reference[i];
  Digits70 square = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Digits70 error = along < 0 ? Digits70(found[i] + reference[i]) : Digits70(found[i] - reference[i]);
    square += error * error;
  }
  return static_cast<double>(sqrt(square));
}

/// Row by row: the columns are the body's axes in space.
std::array<Position, 3> matrix_of(const AttitudeQuaternion& attitude) {
  std::array<Position, 3> matrix{};
  const double w = attitude[0];
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const double a = attitude[1 + i];
    const double b = attitude[1 + j];
    const double c = attitude[1 + k];
    matrix[i][i] = 1 - 2 * (b * b + c * c);
    matrix[i][j] = 2 * (a * b - w * c);
    matrix[j][i] = 2 * (a * b + w * c);
  }
  return matrix;
}

double worst_turn(const Position& moments, const Position& spin, const std::vector<double>& times) {
  const auto attitude = TorqueFreeAttitude::make(moments, spin);
  REQUIRE(attitude);
  double worst = 0;
  for (const double time : times) {
    const ReferenceMotion reference = moved(moments, at_rest_of(spin), time, true);
    const double error = distance(attitude->at(time), reference.turn);
    worst = std::max(worst, std::isfinite(error) ? error : std::numeric_limits<double>::infinity());
  }
  return worst;
}

TEST_CASE("the attitude of a free body is right, forwards and backwards", "[torque free]") {
  CHECK(worst_turn({1, 2, 2.5}, {.6, .7, .9}, {0, 1e-8, 1, -1, 30}) < bound);
  CHECK(worst_turn({2.5, 2, 1}, {.9, -.7, .6}, {1, -10}) < bound);
  CHECK(worst_turn({2, 1, 2.5}, {-.3, -1, .2}, {1, -10}) < bound);
}

TEST_CASE("the attitude is right next to each axis, and so is its turn about momentum", "[torque free]") {
  for (const double off : {1e-1, 1e-4, 1e-12, 1e-16}) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Position spin{off, -off / 2, off / 3};
      spin[axis] = 1;
      INFO(off << " off axis " << axis);
      CHECK(worst_turn({1, 2, 3}, spin, {1, -15}) < bound);
      CHECK(worst_turn({.01, 3, 3.01}, spin, {1}) < bound);
    }
  }
}

TEST_CASE("the attitude is right on the separatrix and next to it", "[torque free]") {
  for (const double off : {0., -1e-12, 1e-4}) {
    INFO(off);
    CHECK(worst_turn({1, 5, 9}, {3, 1, 1 + off}, {-3}) < bound);
    CHECK(worst_turn({9, 5, 1}, {-1 - off, -1, 3}, {10}) < bound);
  }
}

TEST_CASE("the attitude is right for tops, spheres, plates, needles, and steady spins", "[torque free]") {
  for (const Position& moments :
       {Position{1, 1, 2}, Position{1, 2, 2}, Position{1, 1 + 1e-12, 2}, Position{1, 2, 2 - 1e-12},
        Position{1, 1, 1}, Position{1, 2, 3}, Position{1e-4, 1, 1 + 1e-4}, Position{1e-4, 1, 1 + 1e-5}}) {
    INFO(moments[0] << " " << moments[1] << " " << moments[2]);
    CHECK(worst_turn(moments, {.5, .3, 1}, {1, -3}) < bound);
    CHECK(worst_turn(moments, {.5, .3, 1e-7}, {1, -3}) < bound);
  }
  CHECK(worst_turn({1, 2, 3}, {0, .7, 0}, {1, -10}) < bound);
  CHECK(worst_turn({1, 2, 3}, {0, 0, 0}, {1}) == 0);
}

/// The state after whole periods follows from the attitude after one, to 50 digits: q(nT) = q(T)ⁿ.
std::array<Digits70, 4> product(const std::array<Digits70, 4>& p, const std::array<Digits70, 4>& q) {
  return {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
          p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
          p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1],
          p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]};
}

TEST_CASE("after 1e8 periods the attitude is as good as after one", "[torque free]") {
  struct Case {
    Position moments;
    Position spin;
  };
  for (const Case& body : {Case{{1, 2, 2.5}, {.6, .7, .9}}, Case{{1, 2, 2.5}, {1, .3, .2}},
                           Case{{1, 5, 9}, {3, 1, 1 + 1e-12}}, Case{{1, 2, 3}, {1e-2, .9, 1e-3}}}) {
    const Digits70 period = period_of(body.moments, body.spin);
    const ReferenceMotion once = moved(body.moments, at_rest_of(body.spin), period, true);
    const auto attitude = TorqueFreeAttitude::make(body.moments, body.spin);
    for (const std::uint64_t count : {std::uint64_t{100}, std::uint64_t{100'000'000}}) {
      const double time = static_cast<double>(period) * (static_cast<double>(count) + .3);
      std::array<Digits70, 4> whole{1, 0, 0, 0};
      std::array<Digits70, 4> power = once.turn;
      for (std::uint64_t left = count; left > 0; left /= 2) {
        if (left % 2 == 1) whole = product(whole, power);
        power = product(power, power);
      }
      const ReferenceMotion rest =
          moved(body.moments, at_rest_of(body.spin), Digits70(time) - period * Digits70(count), true);
      INFO(count);
      CHECK(distance(attitude->at(time), product(whole, rest.turn)) < bound);
    }
  }
}

TEST_CASE("the attitude is right in every unit of time", "[torque free]") {
  for (const Position& spin : {Position{.6, .7, .9}, Position{1, .3, .2}, Position{1e-3, 1, 1e-4}}) {
    const AttitudeQuaternion plain = TorqueFreeAttitude::make({1, 2, 2.5}, spin)->at(10);
    for (const int power : {-1000, -900, -540, 510, 900, 1000}) {
      const double scale = std::ldexp(1, power);
      const Position faster{spin[0] * scale, spin[1] * scale, spin[2] * scale};
      INFO(power);
      CHECK(TorqueFreeAttitude::make({1, 2, 2.5}, faster)->at(10 / scale) == plain);
    }
  }
}

TEST_CASE("beyond 2^47 turns there is no attitude", "[torque free]") {
  for (const Position& moments : {Position{1, 2, 2.5}, Position{1, 1, 1}, Position{1, 1, 2}}) {
    const auto attitude = TorqueFreeAttitude::make(moments, {.06, .9, .07});
    for (const double time : {2e15, -1e18, 1e25, 1e300})
      for (const double each : attitude->at(time)) CHECK(std::isnan(each));
  }
}

TEST_CASE("angular momentum rests in space", "[torque free]") {
  const Position moments{1, 2, 2.5};
  const Position spin{.6, .7, .9};
  const auto motion = TorqueFree::make(moments, spin);
  const auto attitude = TorqueFreeAttitude::make(moments, spin);
  for (const double time : {0., 1., -30., 1e4, -1e9}) {
    const Position now = motion->spin(time);
    const auto matrix = matrix_of(attitude->at(time));
    for (std::size_t i = 0; i < 3; ++i) {
      double along = 0;
      for (std::size_t k = 0; k < 3; ++k) along += matrix[i][k] * moments[k] * now[k];
      CHECK(std::abs(along - moments[i] * spin[i]) < 4 * bound);
    }
  }
}

TEST_CASE("an attitude that is integrated in doubles misses the bound", "[torque free]") {
  const Position moments{1, 2, 2.5};
  const Position spin{.6, .7, .9};
  const auto motion = TorqueFree::make(moments, spin);
  AttitudeQuaternion q{1, 0, 0, 0};
  const double step = 1e-3;
  for (int k = 0; k < 1000; ++k) {  // a turn by ω at the middle of each step
    const Position w = motion->spin((k + .5) * step);
    const double size = std::hypot(w[0], w[1], w[2]);
    const double s = std::sin(size * step / 2) / size;
    const double c = std::cos(size * step / 2);
    q = {c * q[0] - s * (w[0] * q[1] + w[1] * q[2] + w[2] * q[3]),
         c * q[1] + s * (w[0] * q[0] + q[2] * w[2] - q[3] * w[1]),
         c * q[2] + s * (w[1] * q[0] + q[3] * w[0] - q[1] * w[2]),
         c * q[3] + s * (w[2] * q[0] + q[1] * w[1] - q[2] * w[0])};
  }
  const double error = distance(q, moved(moments, at_rest_of(spin), 1, true).turn);
  CHECK(error < 1e-6);
  CHECK(error > 1e3 * bound);
}

TEST_CASE("many attitudes at once have the bits of one, in every instruction set", "[torque free]") {
  struct Case {
    Position moments;
    Position spin;
  };
  std::vector<double> times{
      0, -0., 1e-300, 1e300, -1e12, std::nan(""), std::numeric_limits<double>::infinity()};
  for (int k = 0; k < 100; ++k) times.push_back(.37 * k * k - 50);
  for (const Case& body :
       {Case{{1, 2, 2.5}, {.6, .7, .9}}, Case{{1, 2, 2.5}, {1, .3, .2}}, Case{{3, 2, 1}, {1e-3, 1, 1e-4}},
        Case{{1, 5, 9}, {3, 1, 1}}, Case{{1, 1, 1}, {1, 2, 3}}}) {
    const auto attitude = TorqueFreeAttitude::make(body.moments, body.spin);
    std::vector<AttitudeQuaternion> expected(times.size());
    attitude->at(times, expected);
    for (const LaneKernels* kernels : runnable_lane_kernels()) {
      INFO(kernels->instruction_set);
      FreeAttitude constants;
      kernels->set_free_attitude(body.moments.data(), body.spin.data(), constants);
      std::vector<AttitudeQuaternion> found(times.size());
      kernels->attitudes_at(constants, times.data(), times.size(), found.data()->data());
      for (std::size_t k = 0; k < times.size(); ++k) {
        AttitudeQuaternion one;
        kernels->attitude_at(constants, times[k], one.data());
        for (std::size_t i = 0; i < 4; ++i) {
          const bool nan = std::isnan(one[i]) && std::isnan(found[k][i]) && std::isnan(expected[k][i]);
          CHECK((nan || std::memcmp(&one[i], &found[k][i], 8) == 0));
          CHECK((nan || std::memcmp(&one[i], &expected[k][i], 8) == 0));
        }
      }
    }
  }
  CHECK_FALSE(TorqueFreeAttitude::make({0, 1, 1}, {1, 0, 0}));
}

}  // namespace
}  // namespace rigor
