// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/kernels/torque_free.h"

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "base/splitmix.h"
#include "catch.h"
#include "numeric/kernels/free_motion_reference.h"
#include "numeric/lane/lane_kernels.h"

namespace rigor {
namespace {

constexpr double unit = 0x1p-53;
constexpr double bound = 16 * unit;  // of every component on its own

double worst_component(const Position& found, const ReferenceMotion& reference) {
  double worst = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Digits70 error = abs(found[i] - reference.spin[i]);
    const double relative = error == 0 ? 0 : static_cast<double>(error / abs(reference.spin[i]));
    worst = std::max(worst, std::isfinite(found[i]) ? relative : std::numeric_limits<double>::infinity());
  }
  return worst;
}

struct FreeBody {
  Position moments{};
  Position spin{};
};

/// The worst component at the times, from step to step.
double worst_error(const FreeBody& body, const std::vector<double>& times) {
  const auto motion = TorqueFree::make(body.moments, body.spin);
  REQUIRE(motion);
  double worst = 0;
  for (const double time : times) {
    const ReferenceMotion reference = moved(body.moments, at_rest_of(body.spin), time);
    worst = std::max(worst, worst_component(motion->spin(time), reference));
  }
  return worst;
}

std::string reason_of(const FreeBody& body) {
  const auto motion = TorqueFree::make(body.moments, body.spin);
  return motion ? std::string() : motion.error().reason;
}

/// On the separatrix exactly: 9 · 4 ω₃² = 1 · 4 ω₁².
constexpr FreeBody on_separatrix{{1, 5, 9}, {3, 1, 1}};

TEST_CASE("the spin of a free body is right in every component, forwards and backwards", "[torque free]") {
  CHECK(worst_error({{1, 2, 2.5}, {.6, .7, .9}}, {0, 1e-8, 1, -1, 10, 100, -100}) < bound);
  CHECK(worst_error({{1, 2, 2.5}, {-1, .3, .2}}, {0, 1, -10, 30}) < bound);
}

TEST_CASE("the order and the signs of the axes do not matter to the error", "[torque free]") {
  const FreeBody body{{1, 2, 2.5}, {.6, .7, .9}};
  std::array<std::size_t, 3> at{0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      FreeBody permuted;
      for (std::size_t i = 0; i < 3; ++i) {
        permuted.moments[i] = body.moments[at[i]];
        permuted.spin[i] = (signs >> i & 1) != 0 ? -body.spin[at[i]] : body.spin[at[i]];
      }
      CHECK(worst_error(permuted, {3}) < bound);
    }
  } while (std::next_permutation(at.begin(), at.end()));
}

TEST_CASE("rotations next to each axis are right, as near as 1e-16", "[torque free]") {
  for (const double off : {1e-1, 1e-2, 1e-4, 1e-8, 1e-12, 1e-16}) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const Position& moments : {Position{1, 2, 3}, Position{.01, 3, 3.01}}) {
        FreeBody body{moments, {off, -off / 2, off / 3}};
        body.spin[axis] = 1;
        INFO(off << " off axis " << axis);
        CHECK(worst_error(body, {1, -20}) < bound);
      }
    }
  }
}

TEST_CASE("on the separatrix the spin is the closed form, and not far from it either", "[torque free]") {
  CHECK(TorqueFree::make(on_separatrix.moments, on_separatrix.spin)->constants().nome == 0);
  for (const double sign : {1., -1.}) {
    FreeBody body = on_separatrix;
    body.spin[0] *= sign;
    CHECK(worst_error(body, {0, -3, 15}) < bound);
    for (const double off : {1e-15, -1e-8, 1e-1}) {
      FreeBody near = body;
      near.spin[2] += off;
      INFO(off);
      CHECK(worst_error(near, {-3, 15}) < bound);
    }
  }
}

TEST_CASE("a difference that no two doubles hold decides on which side of the separatrix a spin is") {
  // I₃ d₁ ω₃² − I₁ d₃ ω₁² for I = (1, 5, 9) is 4 (9 ω₃² − ω₁²), exactly 0 only for ω₁ = 3 ω₃.
  const double w = 1 / 3. + 1e-3;
  const double three = 3 * w;
  const bool exact = std::fma(3, w, -three) == 0;
  CHECK((TorqueFree::make({1, 5, 9}, {three, .1, w})->constants().nome == 0) == exact);
  CHECK(worst_error({{1, 5, 9}, {three, .1, w}}, {1, 10, 30}) < bound);
}

TEST_CASE("tops, spheres, plates and needles are right", "[torque free]") {
  for (const Position& moments :
       {Position{1, 1, 2}, Position{1, 2, 2}, Position{1, 1 + 1e-15, 2}, Position{1, 2, 2 - 1e-15},
        Position{1, 1, 1}, Position{1, 1 + 2e-16, 1 + 1e-15}, Position{1, 2, 3}, Position{1e-8, 1, 1 + 1e-8},
        Position{1e-4, 1, 2}}) {
    INFO(moments[0] << " " << moments[1] << " " << moments[2]);
    CHECK(worst_error({moments, {.5, .3, 1}}, {1, -3}) < bound);
    CHECK(worst_error({moments, {.1, 1, -.2}}, {1, -3}) < bound);
  }
}

TEST_CASE("a spin along an axis, of a sphere, or none at all stays to the last bit", "[torque free]") {
  for (const FreeBody& body : {FreeBody{{1, 2, 3}, {0, .7, 0}}, FreeBody{{1, 1, 1}, {.1, .2, .3}},
                               FreeBody{{1, 2, 3}, {}}, FreeBody{{1, 1, 2}, {.1, .2, 0}}}) {
    const auto motion = TorqueFree::make(body.moments, body.spin);
    REQUIRE(motion);
    CHECK(motion->constants().kind == FreeSpinKind::steady);
    CHECK(motion->spin(1e9) == body.spin);
  }
  CHECK(TorqueFree::make({1, 2, 3}, {1e-200, .7, 0})->constants().kind != FreeSpinKind::steady);
}

TEST_CASE("after 1e8 periods, and before, the spin is as good as after one", "[torque free]") {
  const FreeBody near{{1, 5, 9}, {3, 1, 1 + 1e-12}};
  for (const FreeBody& body :
       {FreeBody{{1, 2, 2.5}, {.6, .7, .9}}, FreeBody{{1, 2, 3}, {.9, 1e-3, 1e-2}}, near}) {
    const Digits70 period = period_of(body.moments, body.spin);
    const auto motion = TorqueFree::make(body.moments, body.spin);
    for (const double count : {1e-8, 1e2, 1e6, 1e8, -1e8}) {
      const double time = static_cast<double>(period) * (count + .3);
      const Digits70 rest = Digits70(time) - period * floor(Digits70(time) / period);
      INFO(count);
      CHECK(worst_component(motion->spin(time), moved(body.moments, at_rest_of(body.spin), rest)) < bound);
    }
  }
}

TEST_CASE("beyond 2^47 turns there is no number, and before the spin is right", "[torque free]") {
  for (const FreeBody& body : {FreeBody{{1, 2, 2.5}, {.6, .7, .9}}, FreeBody{{1, 2, 3}, {1e-3, .9, 1e-3}},
                               FreeBody{{1, 5, 9}, {3, 1, 1.01}}}) {
    const Digits70 period = period_of(body.moments, body.spin);
    const auto motion = TorqueFree::make(body.moments, body.spin);
    for (const double count : {0x1p44, -0x1p46, 0x1.fp46}) {
      const double time = static_cast<double>(period) * count;
      const Digits70 rest = Digits70(time) - period * floor(Digits70(time) / period);
      INFO(count);
      CHECK(worst_component(motion->spin(time), moved(body.moments, at_rest_of(body.spin), rest)) < bound);
    }
    for (const double count : {0x1.01p47, -0x1p48, 0x1p51, 1e17, 1e25, 1e300}) {
      const Position spin = motion->spin(static_cast<double>(period) * count);
      for (const double each : spin) CHECK(std::isnan(each));
    }
  }
}

TEST_CASE("needles are right until there is no number", "[torque free]") {
  for (const double thin : {1e-8, 1e-20, 1e-38, 1e-59}) {
    for (const Position& moments : {Position{thin, 1, 1.5}, Position{thin, 1.5 * thin, 1.5}}) {
      INFO(thin << ' ' << moments[1]);
      const FreeBody body{moments, {.3, .4, .5}};
      const double turn = 2 * (moments[1] == 1 ? std::sqrt(thin) : thin);
      CHECK(worst_error(body, {0, .1 * turn, -turn}) < bound);
      const Position later = TorqueFree::make(body.moments, body.spin)->spin(turn * 1e16);
      for (const double each : later) CHECK(std::isnan(each));
    }
  }
}

TEST_CASE("units do not matter, at 1e±300 neither", "[torque free]") {
  const Position plain = TorqueFree::make({1, 2, 2.5}, {.6, .7, .9})->spin(10);
  for (const int power : {-1000, -600, 600, 1000}) {
    const double scale = std::ldexp(1, power);
    const auto motion =
        TorqueFree::make({scale, 2 * scale, 2.5 * scale}, {.6 / scale, .7 / scale, .9 / scale});
    REQUIRE(motion);
    for (std::size_t i = 0; i < 3; ++i) CHECK(motion->spin(10 * scale)[i] == plain[i] / scale);
  }
}

TEST_CASE("a spin off its axis by less than any normal number does no harm, or is refused") {
  for (const double off : {1e-290, 1e-310, 5e-324}) {
    INFO(off);
    for (const Position& spin : {Position{off, 1, off}, Position{off, 1, 0}, Position{0, -1, off}})
      CHECK(reason_of({{1, 2, 3}, spin}) == "the spin is too near to the middle axis");
    for (const Position& spin : {Position{off, off, 1}, Position{-1, 0, off}, Position{1, off, off}}) {
      const Position later = TorqueFree::make({1, 2, 3}, spin)->spin(2000);
      for (std::size_t i = 0; i < 3; ++i) {
        const bool along = std::abs(spin[i]) == 1;
        CHECK((along ? later[i] == spin[i] : std::abs(later[i]) <= 3 * off));
      }
    }
  }
  CHECK(reason_of({{1, 2, 3}, {0x1p-801, 1.1, 0x1p-802}}) == "the spin is too near to the middle axis");
  for (const double off : {0x1p-799, 1e-200, 1e-100})
    CHECK(worst_error({{1, 2, 3}, {off, 1, -off / 2}}, {0, 10}) < bound);
  CHECK(worst_error({{1, 5, 9}, {3e-200, 1, 1e-200}}, {0, 10}) < bound);
}

TEST_CASE("a top precesses as slowly as it may", "[torque free]") {
  for (const double slow : {1e-80, 1e-104, 1e-110, 1e-140, 1e-163, 1e-200, 1e-290}) {
    INFO(slow);
    for (const double sign : {1., -1.}) {
      CHECK(worst_error({{1, 1, .5}, {1, .5, sign * slow}}, {0, 3, -2000}) < bound);
      CHECK(worst_error({{2, 1, 2}, {1, sign * slow, .5}}, {3}) < bound);
      CHECK(worst_error({{1, 1, 1.5}, {1, -.5, sign * slow}}, {3, std::min(.7 / slow, 1e250)}) < bound);
    }
  }
  for (const double slow : {1e-310, 5e-324}) {
    const Position later = TorqueFree::make({1, 1, .5}, {1, .5, slow})->spin(3);
    CHECK((std::abs(later[0] - 1) < bound && std::abs(later[1] - .5) < bound && later[2] == slow));
  }
}

TEST_CASE("random bodies stay within the bound", "[torque free]") {
  SplitMix random(20);
  const auto number = [&] { return std::ldexp(static_cast<double>(random.next() >> 11), -52) - 1; };
  double worst = 0;
  for (int k = 0; k < 60; ++k) {
    FreeBody body;
    for (std::size_t i = 0; i < 3; ++i) {
      body.moments[i] = 1 + .95 * number();
      body.spin[i] = number();
    }
    worst = std::max(worst, worst_error(body, {20 * number()}));
  }
  CHECK(worst < bound);
}

/// The textbook's: k from its square, in doubles, through Boost.
Position textbook(const FreeBody& body, double time) {
  const auto& [i1, i2, i3] = body.moments;
  const auto& [w1, w2, w3] = body.spin;
  const double energy = i1 * w1 * w1 + i2 * w2 * w2 + i3 * w3 * w3;
  const double momentum = i1 * i1 * w1 * w1 + i2 * i2 * w2 * w2 + i3 * i3 * w3 * w3;
  const double rate = std::sqrt((i3 - i2) * (momentum - energy * i1) / (i1 * i2 * i3));
  const double k =
      std::sqrt(std::min(1., (i2 - i1) * (energy * i3 - momentum) / ((i3 - i2) * (momentum - energy * i1))));
  const double size1 = std::sqrt((energy * i3 - momentum) / (i1 * (i3 - i1)));
  const double size2 = std::sqrt((energy * i3 - momentum) / (i2 * (i3 - i2)));
  const double size3 = std::sqrt((momentum - energy * i1) / (i3 * (i3 - i1)));
  const double angle = std::atan2(w2 / size2, w1 / size1);
  double cn = 0;
  double dn = 0;
  const double sn = boost::math::jacobi_elliptic(k, boost::math::ellint_1(k, angle) + rate * time, &cn, &dn);
  return {size1 * cn, size2 * sn, size3 * dn};
}

TEST_CASE("the textbook's modulus misses the bound: next to the separatrix by far, and after many periods") {
  const auto error = [](const FreeBody& body, double time) {
    return worst_component(textbook(body, time), moved(body.moments, at_rest_of(body.spin), time));
  };
  CHECK(error({{1, 2, 2.5}, {.6, .7, .9}}, 1) < 100 * bound);  // the right formula
  CHECK(error({{1, 5, 9}, {3, 1, 1 + 1e-12}}, 30) > 1e6 * bound);
  CHECK(error({{1, 5, 9}, {3, 1, 1 + 1e-8}}, 30) > 1e3 * bound);
  CHECK(error({{1, 2, 2.5}, {.6, .7, .9}}, 300) > 2 * bound);
}

TEST_CASE("the rates of a free spin are right to 4 u of what their difference is of", "[torque free]") {
  SplitMix random(29);
  const auto number = [&] { return std::ldexp(static_cast<double>(random.next() >> 11), -53); };
  for (int n = 0; n < 300; ++n) {
    const double i1 = 1 + number();
    const Position moments{i1, n % 2 == 0 ? i1 + 1e-12 * number() : 1 + number(), 1 + number()};
    const Position spin{number() - .5, number() - .5, number() - .5};
    const Position rates = free_spin_rates(moments, spin);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      const Digits70 size = abs(Digits70(spin[j]) * spin[k] / moments[i]);
      const Digits70 exact = (Digits70(moments[j]) - moments[k]) * spin[j] * spin[k] / moments[i];
      CHECK(abs(exact - rates[i]) <= 4 * unit * (moments[j] + moments[k]) * size);
    }
  }
}

TEST_CASE("energy and momentum are kept, and the motion runs on from any of its spins", "[torque free]") {
  const FreeBody body{{1, 2, 2.5}, {.6, .7, .9}};
  const auto motion = TorqueFree::make(body.moments, body.spin);
  for (const double time : {-1e6, -3., .1, 1e3, 1e7}) {
    const Position spin = motion->spin(time);
    double energy = 0;
    double momentum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      energy += body.moments[i] * spin[i] * spin[i];
      momentum += std::pow(body.moments[i] * spin[i], 2);
    }
    CHECK(std::abs(energy / 3.365 - 1) < 32 * unit);
    CHECK(std::abs(momentum / 7.3825 - 1) < 32 * unit);
    const auto on = TorqueFree::make(body.moments, spin);
    const Position later = on->spin(5);
    const Position expected = motion->spin(time + 5);
    // time + 5 is rounded, and so is the spin from which the second motion starts.
    const double rounded = (std::abs(time) + 100) * unit;
    for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(later[i] - expected[i]) < 4 * rounded);
    const Position back = on->spin(-time);
    for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(back[i] - body.spin[i]) < 40 * rounded);
  }
}

TEST_CASE("the rates at the time 0 are Euler's", "[torque free]") {
  const FreeBody body{{1, 2, 2.5}, {.6, .7, .9}};
  const auto motion = TorqueFree::make(body.moments, body.spin);
  const double step = 1e-5;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const double rate = (motion->spin(step)[i] - motion->spin(-step)[i]) / (2 * step);
    const double euler = (body.moments[j] - body.moments[k]) * body.spin[j] * body.spin[k] / body.moments[i];
    CHECK(std::abs(rate - euler) < 1e-9);  // step² and u / step
  }
}

TEST_CASE("many times at once give the bits of one, in every instruction set", "[torque free]") {
  const std::vector<FreeBody> bodies{
      {{1, 2, 2.5}, {.6, .7, .9}}, {{3, 2, 1}, {1e-3, 1, 1e-4}}, on_separatrix, {{1, 2, 3}, {0, 1, 0}}};
  std::vector<double> times{0, -0., 1e-300, 1e300, -1e12};
  for (int k = 0; k < 100; ++k) times.push_back(.37 * k * k - 50);
  times.push_back(std::numeric_limits<double>::infinity());
  times.push_back(std::nan(""));
  for (const FreeBody& body : bodies) {
    const auto motion = TorqueFree::make(body.moments, body.spin);
    std::vector<Position> expected(times.size());
    motion->spins(times, expected);
    for (const LaneKernels* kernels : runnable_lane_kernels()) {
      INFO(kernels->instruction_set);
      FreeSpin spin;
      kernels->set_free_spin(body.moments.data(), body.spin.data(), spin);
      std::vector<Position> found(times.size());
      kernels->free_spins_at(spin, times.data(), times.size(), found.data()->data());
      for (std::size_t k = 0; k < times.size(); ++k) {
        INFO(times[k]);
        Position one;
        kernels->free_spin_at(spin, times[k], one.data());
        for (std::size_t i = 0; i < 3; ++i) {
          const bool both_nan = std::isnan(one[i]) && std::isnan(found[k][i]) && std::isnan(expected[k][i]);
          CHECK((both_nan || std::memcmp(&one[i], &found[k][i], 8) == 0));
          CHECK((both_nan || std::memcmp(&one[i], &expected[k][i], 8) == 0));
        }
      }
    }
  }
}

TEST_CASE("what does not move by these equations is refused with its reason", "[torque free]") {
  const double infinity = std::numeric_limits<double>::infinity();
  const auto reason = [](const Position& moments, const Position& spin) {
    return reason_of({moments, spin});
  };
  CHECK(reason({1, 2, infinity}, {1, 2, 3}) == "a moment is not finite");
  CHECK(reason({1, 2, 3}, {1, std::nan(""), 3}) == "the spin is not finite");
  CHECK(reason({1, -2, 3}, {1, 2, 3}) == "a moment is negative");
  CHECK(reason({0, 2, 2}, {1, 2, 3}) == "a moment is zero: nothing determines the spin about its axis");
  CHECK(reason({1e-70, 2, 2}, {1, 2, 3}) == "the moments are too unlike");
  CHECK(reason({1e-50, 1, 2}, {0, 1e300, 1e300}) == "the spin grows beyond all doubles");
  CHECK(reason({1e-308, 2e-308, 2.5e-308}, {1e308, 1e308, 1e308}).empty());
}

}  // namespace
}  // namespace rigor
