// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/body/shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "catch.h"
#include "numeric/body/inertia.h"

namespace rigor {
namespace {

constexpr double u = 0x1p-53;

/// One of each kind, with unequal extents where the shape may have them.
std::vector<Shape> one_of_each() {
  std::vector<Shape> shapes;
  for (const ShapeInfo& kind : shape_table()) {
    const bool round = kind.kind == ShapeKind::sphere || kind.kind == ShapeKind::shell;
    shapes.push_back({kind.kind, 0.7, round ? Position{0.3, 0.3, 0.3} : Position{0.3, 0.2, 0.9}});
  }
  return shapes;
}

/// The largest |x_k| in the shape.
double reach(const Shape& shape, std::size_t k) {
  if (info(shape.kind).over[k] == 0) return 0;
  return shape.kind == ShapeKind::cone && k == 2 ? 0.75 * shape.extents[k] : shape.extents[k];
}

double sum_of_squares(const Body& body, std::size_t k) {
  double sum = 0;
  for (std::size_t i = 0; i < body.size(); ++i)
    sum += body.masses[i] * body.positions[k][i] * body.positions[k][i];
  return sum;
}

TEST_CASE("the textbook moments of every shape") {
  struct Known {
    Shape shape;
    Position moments;
  };
  const double m = 2;
  const std::vector<Known> textbook{
      {{ShapeKind::rod, m, {0, 0, 1.5}}, {m * 9 / 12, m * 9 / 12, 0}},
      {{ShapeKind::hoop, m, {3, 3, 0}}, {m * 9 / 2, m * 9 / 2, m * 9}},
      {{ShapeKind::disc, m, {3, 3, 0}}, {m * 9 / 4, m * 9 / 4, m * 9 / 2}},
      {{ShapeKind::plate, m, {1, 2, 0}}, {m * 16 / 12, m * 4 / 12, m * 20 / 12}},
      {{ShapeKind::box, m, {1, 2, 3}}, {m * (16 + 36) / 12, m * (4 + 36) / 12, m * (4 + 16) / 12}},
      {{ShapeKind::sphere, m, {3, 3, 3}}, {m * 9 * 2 / 5, m * 9 * 2 / 5, m * 9 * 2 / 5}},
      {{ShapeKind::shell, m, {3, 3, 3}}, {m * 9 * 2 / 3, m * 9 * 2 / 3, m * 9 * 2 / 3}},
      {{ShapeKind::ellipsoid, m, {1, 2, 3}}, {m * 13 / 5, m * 10 / 5, m * 5 / 5}},
      {{ShapeKind::cylinder, m, {3, 3, 2}}, {m * (9. / 4 + 16. / 12), m * (9. / 4 + 16. / 12), m * 9 / 2}},
      {{ShapeKind::cone, m, {3, 3, 4}},
       {m * (9 * 3. / 20 + 16 * 3. / 80), m * (9 * 3. / 20 + 16 * 3. / 80), m * 9 * 3 / 10}},
  };
  REQUIRE(textbook.size() == shape_table().size());
  for (const auto& [shape, moments] : textbook) {
    const auto known = inertia_of(shape);
    REQUIRE(known);
    for (std::size_t i = 0; i < 3; ++i) {
      INFO(info(shape.kind).name << " " << i);
      CHECK(std::abs(known->inertia[i][i] - moments[i]) <= 4 * u * moments[i]);
    }
    CHECK(known->mass == m);
  }
}

TEST_CASE("the quadrature of every shape has its mass, centre and inertia to a few roundings") {
  for (const Shape& shape : one_of_each()) {
    const auto body = quadrature_body("body", shape);
    REQUIRE(body);
    INFO(info(shape.kind).name);
    CHECK(std::abs(total_mass(*body) - shape.mass) <= 8 * u * shape.mass);
    const double whole = body->masses.front() * static_cast<double>(body->size());
    CHECK(whole == shape.mass);
    const SharpPosition centre = *sharp_centre_of_mass(points_of(*body));
    const InertiaTensor inertia = *inertia_tensor(*body);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(std::abs(centre[i].high) <= 8 * u * shape.extents[i]);
      for (std::size_t j = 0; j < 3; ++j) {
        const double exact = body->known->inertia[i][j];
        const double scale = i == j ? exact : shape.mass * shape.extents[i] * shape.extents[j];
        CHECK(std::abs(inertia[i][j] - exact) <= 8 * u * scale);
      }
    }
    CHECK(std::all_of(body->masses.begin(), body->masses.end(), [](double mass) { return mass > 0; }));
  }
}

TEST_CASE("a sampled cloud of every shape has its second moments within five standard errors") {
  constexpr std::size_t count = 20'000;
  for (const Shape& shape : one_of_each()) {
    const auto body = sampled_body("body", shape, count, 42);
    REQUIRE(body);
    CHECK(std::abs(total_mass(*body) - shape.mass) <= static_cast<double>(count) * u * shape.mass);
    const ShapeInfo& kind = info(shape.kind);
    const InertiaTensor inertia = *inertia_tensor(*body);
    for (std::size_t k = 0; k < 3; ++k) {
      INFO(kind.name << " axis " << k);
      const double exact = kind.over[k] / kind.under[k] * shape.extents[k] * shape.extents[k];
      const double bound = 5 * reach(shape, k) * reach(shape, k) / std::sqrt(static_cast<double>(count));
      CHECK(std::abs(sum_of_squares(*body, k) / shape.mass - exact) <= bound);
      CHECK(bound <= 0.6 * exact);  // so that it tells one shape from another
      const std::size_t l = (k + 1) % 3;
      CHECK(std::abs(inertia[k][l]) / shape.mass <=
            5 * reach(shape, k) * reach(shape, l) / std::sqrt(static_cast<double>(count)));
    }
  }
}

TEST_CASE("the error of a sampled cloud falls as the square root of the number of particles") {
  const Shape shape{ShapeKind::box, 1, {1, 1, 1}};
  double few = 0;
  double many = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    few += std::pow(sum_of_squares(*sampled_body("b", shape, 100, seed), 0) - 1. / 3, 2);
    many += std::pow(sum_of_squares(*sampled_body("b", shape, 10'000, seed), 0) - 1. / 3, 2);
  }
  CHECK(few / many > 100 / 2.);
  CHECK(few / many < 100 * 2.);
}

TEST_CASE("all quadrature points lie in their shape") {
  for (const Shape& shape : one_of_each()) {
    const auto body = quadrature_body("body", shape);
    for (std::size_t i = 0; i < body->size(); ++i) {
      Position r = body->position(i);
      for (std::size_t k = 0; k < 3; ++k) r[k] = shape.extents[k] > 0 ? r[k] / shape.extents[k] : 0;
      const double rho = r[0] * r[0] + r[1] * r[1];
      const double slack = 8 * u;
      INFO(info(shape.kind).name);
      CHECK(std::max({std::abs(r[0]), std::abs(r[1]), std::abs(r[2])}) <= 1 + slack);
      if (shape.kind == ShapeKind::sphere || shape.kind == ShapeKind::ellipsoid)
        CHECK(rho + r[2] * r[2] <= 1 + slack);
      if (shape.kind == ShapeKind::cylinder || shape.kind == ShapeKind::disc) CHECK(rho <= 1 + slack);
      if (shape.kind == ShapeKind::hoop) CHECK(std::abs(rho - 1) <= slack);
      if (shape.kind == ShapeKind::shell) CHECK(std::abs(rho + r[2] * r[2] - 1) <= slack);
      if (shape.kind == ShapeKind::cone) CHECK(std::sqrt(rho) <= 0.75 - r[2] + slack);
    }
  }
}

TEST_CASE("impossible shapes are refused with the value") {
  const auto reason = [](const Shape& shape) {
    const auto body = quadrature_body("body", shape);
    const auto cloud = sampled_body("body", shape, 10, 1);
    CHECK_FALSE(cloud);
    return body ? "accepted" : body.error().reason;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(reason({ShapeKind::sphere, 0, {1, 1, 1}}) ==
        "the sphere has the mass 0 kg, which must be finite and positive");
  CHECK(reason({ShapeKind::box, 1, {1, -2, 1}}) ==
        "the box has the half extent -2 m, which must be finite and positive");
  CHECK(reason({ShapeKind::rod, 1, {0, 0, nan}}) ==
        "the rod has the half extent nan m, which must be finite and positive");
  CHECK(reason({ShapeKind::box, 1, {1e200, 1, 1}}) == "the box's moments of inertia overflow");
  CHECK(sampled_body("body", {ShapeKind::box, 1, {1, 1, 1}}, 0, 1).error().reason ==
        "the body has no particles");
}

}  // namespace
}  // namespace rigor
