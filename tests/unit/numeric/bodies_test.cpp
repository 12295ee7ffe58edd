// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/body/bodies.h"

#include <cmath>

#include "catch.h"
#include "numeric/body/inertia.h"
#include "numeric/body/shapes.h"

namespace rigor {
namespace {

constexpr double u = 0x1p-53;

void check_known(const Body& body, double scale) {
  REQUIRE(body.known);
  const InertiaTensor inertia = *inertia_tensor(body);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      CHECK(std::abs(inertia[i][j] - body.known->inertia[i][j]) <= 32 * u * scale);
}

TEST_CASE("the z axis of a body becomes another axis, with its inertia") {
  const Body rod = *quadrature_body("rod", {ShapeKind::rod, 3, {0, 0, 1}});
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Body turned = along_axis(rod, axis);
    CHECK(turned.known->inertia[axis][axis] == 0);
    CHECK(turned.known->inertia[(axis + 1) % 3][(axis + 1) % 3] == 1);
    CHECK(std::abs(turned.positions[axis][0]) == std::abs(rod.positions[2][0]));
    check_known(turned, 1);
  }
  CHECK(along_axis(rod, 2).positions == rod.positions);
  const Body box = *quadrature_body("box", {ShapeKind::box, 3, {1, 2, 3}});
  CHECK(along_axis(box, 0).known->inertia[0][0] == box.known->inertia[2][2]);
  CHECK(along_axis(box, 0).known->inertia[1][1] == box.known->inertia[0][0]);
}

TEST_CASE("two boxes side by side are a box twice as long") {
  const Body half = *quadrature_body("half", {ShapeKind::box, 1, {0.5, 1, 1}});
  const auto whole = joined("whole", {{half, {10, 0, 0}}, {half, {11, 0, 0}}});
  REQUIRE(whole);
  const auto box = inertia_of({ShapeKind::box, 2, {1, 1, 1}});
  for (std::size_t i = 0; i < 3; ++i)
    CHECK(std::abs(whole->known->inertia[i][i] - box->inertia[i][i]) <= 64 * u);
  check_known(*whole, 100 * 2);  // offsets of 10 cost digits
  CHECK(whole->known->mass == 2);
  CHECK(whole->size() == 16);
}

TEST_CASE("an offset along a diagonal makes products of inertia") {
  const Body ball = *quadrature_body("ball", {ShapeKind::sphere, 1, {1, 1, 1}});
  const auto dumbbell = joined("dumbbell", {{ball, {1, 1, 0}}, {ball, {-1, -1, 0}}});
  REQUIRE(dumbbell);
  CHECK(dumbbell->known->inertia[0][1] == -2);
  check_known(*dumbbell, 8);
}

TEST_CASE("with a part whose inertia is not known, the whole's is not") {
  const Body ball = *quadrature_body("ball", {ShapeKind::sphere, 1, {1, 1, 1}});
  const Body point = *random_cloud("point", 1, 1);
  CHECK_FALSE(joined("both", {{ball, {1, 0, 0}}, {point, {0, 0, 0}}})->known);
  CHECK(joined("none", {}).error().reason == "the body has no parts");
}

TEST_CASE("a body with given moments has them, a plate is accepted, what cannot exist is refused") {
  for (const Position& moments : {Position{1, 2, 2.5}, Position{1, 2, 3}, Position{0, 1, 1}}) {
    const InertiaTensor inertia{{{moments[0], 0, 0}, {0, moments[1], 0}, {0, 0, moments[2]}}};
    const auto body = body_with_inertia("top", 0.5, inertia);
    REQUIRE(body);
    check_known(*body, 3);
    CHECK(total_mass(*body) == Approx(0.5).epsilon(8 * u));
  }
  CHECK_FALSE(body_with_inertia("top", 0.5, {{{1, 0, 0}, {0, 2, 0}, {0, 0, 3.1}}}));
  CHECK(body_with_inertia("top", 0, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}).error().reason ==
        "the body has the mass 0 kg, which must be finite and positive");
  const auto full = body_with_inertia("full", 2, {{{4, 0.5, -1}, {0.5, 5, 0.25}, {-1, 0.25, 6}}});
  REQUIRE(full);
  check_known(*full, 6);
}

TEST_CASE("second moments that no mass can have are refused, those of a flat body are not") {
  const auto hollow = equimomental_body("hollow", 1, {{{-16, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
  REQUIRE_FALSE(hollow);
  CHECK(hollow.error().reason == "its mean square extent along an axis is -16 m^2, which cannot be negative");
  CHECK(equimomental_body("flat", 1, {{{1, 0, 0}, {0, 1, 0}, {0, 0, -1e-16}}}));
}

TEST_CASE("parts so far apart that their moments overflow are refused") {
  const Body ball = *quadrature_body("ball", {ShapeKind::sphere, 1, {1, 1, 1}});
  CHECK(joined("far", {{ball, {1e160, 1e160, 0}}, {ball, {0, 0, 0}}}).error().reason ==
        "the inertia tensor overflows");
}

TEST_CASE("parts far from the origin lose no digit of what they are about their common centre") {
  const Body ball = *quadrature_body("ball", {ShapeKind::sphere, 1, {1, 1, 1}});
  const auto near = joined("pair", {{ball, {0, 0, 0}}, {ball, {4, 2, 8}}});
  const auto far = joined("pair", {{ball, {0x1p40, -0x1p40, 0}}, {ball, {0x1p40 + 4, 2 - 0x1p40, 8}}});
  REQUIRE((near && far));
  CHECK(far->known->inertia == near->known->inertia);
  CHECK(far->positions == near->positions);
}

}  // namespace
}  // namespace rigor
