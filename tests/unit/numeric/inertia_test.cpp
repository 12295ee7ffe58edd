// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/body/inertia.h"

#include <cmath>
#include <limits>

#include "catch.h"

namespace rigor {
namespace {

constexpr double u = 0x1p-53;

TEST_CASE("the inertia tensor of two masses has the products of inertia with a minus") {
  const auto body = point_masses("two", {1, 1}, {{1, 0, 2}, {-1, 0, -2}});
  const auto inertia = inertia_tensor(*body);
  REQUIRE(inertia);
  CHECK(*inertia == InertiaTensor{{{8, 0, -4}, {0, 10, 0}, {-4, 0, 2}}});
}

TEST_CASE("the inertia tensor is about the centre of mass, wherever the body is") {
  Body body = *point_masses("three", {1, 2, 3}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const InertiaTensor at_rest = *inertia_tensor(body);
  for (auto& coordinates : body.positions)
    for (double& x : coordinates) x += 0x1p20;
  const InertiaTensor far = *inertia_tensor(body);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) CHECK(std::abs(far[i][j] - at_rest[i][j]) <= 0x1p20 * 32 * u);
}

TEST_CASE("the sharp inertia tensor of a nearly symmetric body keeps the difference of its moments") {
  Body body = *point_masses("six", {1, 1, 1, 1, 1, 1},
                            {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
  body.positions[0][0] = 1 + 0x1p-50;  // I_22 − I_11 = Σ m (x² − y²), with x about its mean
  const auto sharp = sharp_mass_sums(points_of(body));
  REQUIRE(sharp);
  const HighLow first = sharp->inertia[0][0];
  const HighLow second = sharp->inertia[1][1];
  const double gap = (second.high - first.high) + (second.low - first.low);
  const double exact = 0x1p-49 + 0x1p-100 * 5 / 6;
  CHECK(std::abs(gap - exact) <= 4 * u * exact);
  const InertiaTensor plain = *inertia_tensor(body);
  CHECK(std::abs(plain[1][1] - plain[0][0] - exact) <= 8 * u);
}

TEST_CASE("a total mass is rounded once, however unlike the masses are") {
  Body body{"unlike", {1, 0x1p-53, 0x1p-53, 0x1p-60, 1e-30}, {}, {}};
  CHECK(total_mass(body) == 1 + 0x1p-52);
  body.masses = {1e16, 1, -0.0, 1, 1e-3};
  CHECK(total_mass(body) == 1e16 + 2);
}

TEST_CASE("a total mass that overflows is infinite") {
  Body body{"heavy", {1e308, 1e308}, {}, {}};
  CHECK(total_mass(body) == std::numeric_limits<double>::infinity());
  body.masses = {1e308, 1};
  CHECK(total_mass(body) == 1e308);
}

TEST_CASE("an inertia tensor that there is not is an error, not a number") {
  Body body{"nobody", {}, {}, {}};
  CHECK(inertia_tensor(body).error().reason == "the body has no particles");
  body = *point_masses("far", {1, 1}, {{1e200, 0, 0}, {-1e200, 0, 0}});
  CHECK(inertia_tensor(body).error().reason == "the inertia tensor overflows");
}

}  // namespace
}  // namespace rigor
