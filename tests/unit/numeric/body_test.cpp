// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/body/body.h"

#include <cmath>
#include <limits>

#include "catch.h"
#include "numeric/body/inertia.h"
#include "numeric/family/family_values.h"
#include "numeric/kernels/plate_families.h"

namespace rigor {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

template <class T>
std::string reason(const Result<T>& result) {
  return result ? "accepted" : result.error().reason;
}

std::string of_masses(const std::vector<double>& masses) {
  return reason(point_masses("points", masses, std::vector<Position>(masses.size(), Position{1, 2, 3})));
}

double up(double value, int steps) {
  for (int k = 0; k < steps; ++k) value = std::nextafter(value, infinity);
  return value;
}

TEST_CASE("a body that cannot exist is refused with the particle and the value") {
  CHECK(of_masses({}) == "the body has no particles");
  CHECK(of_masses({1, -2}) == "particle 2 has the mass -2 kg, which must be finite and not negative");
  CHECK(of_masses({not_a_number}) == "particle 1 has the mass nan kg, which must be finite and not negative");
  CHECK(of_masses({1, infinity}) == "particle 2 has the mass inf kg, which must be finite and not negative");
  CHECK(of_masses({0, 0}) == "the body has no mass");
  CHECK(of_masses({1e308, 1e308}) == "the sum of the masses overflows");
  CHECK(of_masses({0, 1}) == "accepted");
  CHECK(reason(point_masses("p", {1}, {{0, not_a_number, 0}})) ==
        "particle 1 has y = nan m, which must be finite");
  CHECK(reason(point_masses("p", {1, 1}, {{0, 0, 0}})) == "2 masses, but 1 positions");
}

TEST_CASE("a body is moved to its centre of mass") {
  const auto body = point_masses("two", {1, 3}, {{0, 5, 0}, {4, 5, -8}});
  REQUIRE(body);
  CHECK(body->position(0) == Position{-3, 0, 6});
  CHECK(body->position(1) == Position{1, 0, -2});
}

TEST_CASE("a body far from the origin keeps the digits that its coordinates had") {
  const auto near = random_cloud("cloud", 100, 7);
  Body far = *near;
  for (auto& coordinates : far.positions)
    for (double& x : coordinates) x += 1e8;
  const auto back = centred(far);
  REQUIRE(back);
  const double lost = 1e8 * std::numeric_limits<double>::epsilon();
  for (std::size_t k = 0; k < near->size(); ++k)
    for (std::size_t axis = 0; axis < 3; ++axis)
      CHECK(std::abs(back->positions[axis][k] - near->positions[axis][k]) <= lost);
}

TEST_CASE("a random cloud is the same for the same seed, and another for another") {
  const auto a = random_cloud("cloud", 50, 1);
  const auto b = random_cloud("cloud", 50, 1);
  const auto c = random_cloud("cloud", 50, 2);
  REQUIRE((a && b && c));
  CHECK(a->masses == b->masses);
  CHECK(a->positions == b->positions);
  CHECK(a->masses != c->masses);
  CHECK(a->masses[0] == 0.4334384248277191);  // 1 − 2^-53 times the first 53 bits of SplitMix(1)
  CHECK(reason(random_cloud("cloud", 0, 1)) == "the body has no particles");
  CHECK(reason(random_cloud("cloud", most_particles + 1, 1)) ==
        "the body has 10000001 particles, at most 10000000");
}

TEST_CASE("moments obey the triangle inequality, in every order, up to 4 units in the last place") {
  for (std::size_t i = 0; i < 3; ++i) {
    Position moments{0.1, 0.1, 0.1};
    moments[(i + 1) % 3] = 0.2;
    moments[i] = 0.3;  // below 0.1 + 0.2 as doubles
    CHECK(check_moments(moments));
    moments[(i + 1) % 3] = 0.25;
    moments[(i + 2) % 3] = 0.125;
    moments[i] = 0.375;
    CHECK(check_moments(moments));
    moments[i] = up(0.375, 4);
    CHECK(check_moments(moments));
    moments[i] = up(0.375, 5);
    CHECK_FALSE(check_moments(moments));
  }
  CHECK(reason(check_moments({1, 2, 3.5})) ==
        "moment of inertia 3 is 3.5 kg m^2, greater than the sum of the others, 1 and 2");
  CHECK(reason(check_moments({1, -2, 3})) ==
        "moment of inertia 2 is -2 kg m^2, which must be finite and not negative");
  CHECK_FALSE(check_moments({1, not_a_number, 1}));
  CHECK(check_moments({0, 0, 0}));
  CHECK(check_moments({0, 1e-310, 1e-310}));  // a rod, subnormal
  CHECK(check_moments({1e308, 1e308, 1e308}));
}

TEST_CASE("a tensor obeys the triangle inequality as its moments do, however it is turned") {
  CHECK(check_inertia({{{1, 0, 0}, {0, 2, 0}, {0, 0, 3}}}));
  CHECK(check_inertia({{{1, 0, 0}, {0, 2, 0}, {0, 0, up(3, 4)}}}));
  CHECK_FALSE(check_inertia({{{1, 0, 0}, {0, 2, 0}, {0, 0, up(3, 5)}}}));
  CHECK(check_inertia({{{0, 0, 0}, {0, 1e-300, 0}, {0, 0, 1e-300}}}));
  // A point mass at (1, 2, 3), a rod through the origin: two second moments vanish.
  const InertiaTensor rod{{{13, -2, -3}, {-2, 10, -6}, {-3, -6, 5}}};
  CHECK(check_inertia(rod));
  InertiaTensor less = rod;
  less[2][2] = up(5, 12);
  less[0][0] = less[1][1] = 4;
  CHECK(reason(check_inertia(less)) ==
        "a principal moment of the inertia tensor is greater than the sum of the others");
  CHECK(reason(check_inertia({{{1, 0, 0}, {0.5, 2, 0}, {0, 0, 2}}})) ==
        "the inertia tensor is not symmetric: I_12 = 0, I_21 = 0.5");
  CHECK(reason(check_inertia({{{1, 0, 0}, {0, infinity, 0}, {0, 0, 2}}})) ==
        "the inertia tensor has I_22 = inf, which must be finite");
  CHECK_FALSE(check_inertia({{{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}}));
}

TEST_CASE("no rod or plate is refused for the rounding of its sums, in whatever direction it lies") {
  SplitMix bits(3);
  for (int time = 0; time < 500; ++time) {
    const Position e = scaled(draw_direction(bits), draw_positive(bits));
    CHECK(check_inertia(*inertia_tensor(*point_masses("rod", {0.7, 0.7}, {e, scaled(e, -1)}))));
    const InertiaTensor axes = rotation_of(draw_quaternion(bits));
    std::vector<Position> points;
    for (int k = 0; k < 5; ++k)
      points.push_back(sum(scaled(axes[0], uniform_sign(bits)), scaled(axes[1], uniform_sign(bits))));
    CHECK(check_inertia(*inertia_tensor(*point_masses("plate", {1, 0.3, 0.5, 2, 0.1}, points))));
  }
}

TEST_CASE("a rod is accepted after a shift by half its length and back, at every scale") {
  SplitMix bits(4);
  for (const double length : {1e-9, 1e-3, 1.0, 1e6}) {
    for (int time = 0; time < 200; ++time) {
      const double moment = length * length / 12;
      InertiaTensor inertia{{{moment, 0, 0}, {0, moment, 0}, {0, 0, 0}}};
      const Position d = scaled(draw_direction(bits), length / 2);
      for (const double sign : {1.0, -1.0}) {
        for (std::size_t i = 0; i < 3; ++i)
          for (std::size_t j = 0; j < 3; ++j)
            inertia[i][j] += sign * ((i == j ? length * length / 4 : 0) - d[i] * d[j]);
      }
      CHECK(check_inertia(inertia));
    }
    CHECK_FALSE(check_inertia({{{length, 0, 0}, {0, length * (1 + 1e-14), 0}, {0, 0, 0}}}));
  }
}

TEST_CASE("of 100,000 plates at the edge of what is possible every one is decided as in integers") {
  SplitMix bits(5);
  int valid = 0;
  int wrong = 0;
  constexpr int count = 100'000;
  for (int k = 0; k < count; ++k) {
    const InertiaTensor inertia = nearly_a_plate(bits);
    const bool expected = is_valid_exactly(inertia);
    valid += expected ? 1 : 0;
    wrong += check_inertia(inertia).has_value() != expected ? 1 : 0;
  }
  CHECK(wrong == 0);
  CHECK(valid > count / 4);
  CHECK(valid < count - count / 8);
}

}  // namespace
}  // namespace rigor
