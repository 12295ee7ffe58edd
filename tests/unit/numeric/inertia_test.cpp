// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/inertia.h"

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
  const auto sharp = sharp_inertia_tensor(body);
  REQUIRE(sharp);
  const HighLow first = (*sharp)[0][0];
  const HighLow second = (*sharp)[1][1];
  const double gap = (second.high - first.high) + (second.low - first.low);
  const double exact = 0x1p-49 + 0x1p-100 * 5 / 6;
  CHECK(std::abs(gap - exact) <= 4 * u * exact);
  const InertiaTensor plain = *inertia_tensor(body);
  CHECK(std::abs(plain[1][1] - plain[0][0] - exact) <= 8 * u);
  CHECK(sharp_inertia_tensor(Body{}).error().reason == "the body has no particles");
}

TEST_CASE("principal moments ascend, and the axes that go with them are right-handed") {
  const InertiaTensor inertia{{{3, 1, 0.5}, {1, 4, -0.25}, {0.5, -0.25, 5}}};
  const auto axes = principal_axes(inertia);
  const auto moments = principal_moments(inertia);
  REQUIRE((axes && moments));
  CHECK((*moments)[0] <= (*moments)[1]);
  CHECK((*moments)[1] <= (*moments)[2]);
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(std::abs(axes->moments[k] - (*moments)[k]) <= 14 * u * 6);
    const Position& e = axes->axes[k];
    for (std::size_t i = 0; i < 3; ++i) {
      const double image = inertia[i][0] * e[0] + inertia[i][1] * e[1] + inertia[i][2] * e[2];
      CHECK(std::abs(image - axes->moments[k] * e[i]) <= 64 * u * 6);
    }
    const Position& f = axes->axes[(k + 1) % 3];
    const Position& g = axes->axes[(k + 2) % 3];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t l = (i + 2) % 3;
      CHECK(std::abs(e[i] - (f[j] * g[l] - f[l] * g[j])) <= 16 * u);
    }
  }
}

TEST_CASE("a diagonal tensor has the coordinate axes") {
  const auto axes = principal_axes({{{3, 0, 0}, {0, 1, 0}, {0, 0, 2}}});
  REQUIRE(axes);
  CHECK(axes->moments == Position{1, 2, 3});
  CHECK(axes->axes[0] == Position{0, 1, 0});
  CHECK(axes->axes[1] == Position{0, 0, 1});
  CHECK(axes->axes[2] == Position{1, 0, 0});
}

TEST_CASE("what is not finite is an error, not a number") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(principal_moments({{{1, 0, 0}, {0, nan, 0}, {0, 0, 1}}}).error().reason ==
        "the inertia tensor is not finite");
  CHECK(principal_axes({{{1, 0, 0}, {0, nan, 0}, {0, 0, 1}}}).error().reason ==
        "the inertia tensor is not finite");
  Body body{"nobody", {}, {}, {}};
  CHECK(inertia_tensor(body).error().reason == "the body has no particles");
  body = *point_masses("far", {1, 1}, {{1e200, 0, 0}, {-1e200, 0, 0}});
  CHECK(inertia_tensor(body).error().reason == "the inertia tensor overflows");
}

}  // namespace
}  // namespace rigor
