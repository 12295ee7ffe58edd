// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/body/body_errors.h"

#include <algorithm>
#include <cmath>

#include "base/splitmix.h"
#include "catch.h"
#include "numeric/body/shapes.h"
#include "numeric/program/uniform.h"
#include "numeric/run/run_decimal.h"

namespace rigor {
namespace {

using Digits = Decimal<100>;
using DigitsTensor = std::array<std::array<Digits, 3>, 3>;

/// About their centre of mass, without a rounding that would count.
DigitsTensor inertia_of(const std::vector<double>& masses, const std::array<std::vector<double>, 3>& at) {
  Digits mass = 0;
  std::array<Digits, 3> first{};
  DigitsTensor second{};
  for (std::size_t k = 0; k < masses.size(); ++k) {
    mass += masses[k];
    for (std::size_t i = 0; i < 3; ++i) {
      first[i] += Digits(masses[k]) * at[i][k];
      for (std::size_t j = 0; j < 3; ++j) second[i][j] += Digits(masses[k]) * at[i][k] * at[j][k];
    }
  }
  DigitsTensor inertia{};
  Digits trace = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) inertia[i][j] = first[i] * first[j] / mass - second[i][j];
    trace -= inertia[i][i];
  }
  for (std::size_t i = 0; i < 3; ++i) inertia[i][i] += trace;
  return inertia;
}

double greatest_difference(const DigitsTensor& a, const DigitsTensor& b) {
  Digits greatest = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) greatest = std::max<Digits>(greatest, abs(a[i][j] - b[i][j]));
  return static_cast<double>(greatest);
}

DigitsTensor known_of(const Body& body) {
  DigitsTensor known{};
  REQUIRE(body.known);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      known[i][j] = Digits(body.known->inertia[i][j]) + body.known->low[i][j];
  return known;
}

/// The particles as they are held and what is known of the whole keep their bounds.
void check(const Body& body, const DigitsTensor& exact) {
  const double held = greatest_difference(inertia_of(body.masses, body.positions), exact);
  CHECK(held <= inertia_error(body));
  if (body.known && body.known->is_sharp)
    CHECK(greatest_difference(known_of(body), exact) <= body.known->error);
}

TEST_CASE("points that are moved to their centre stay within the bounds of their places", "[body errors]") {
  SplitMix bits(3);
  for (int n = 0; n < 60; ++n) {
    const double far = std::pow(10, 12 * uniform(bits));
    std::vector<double> masses;
    std::vector<Position> places;
    for (std::uint64_t k = 0, count = 1 + bits.below(9); k < count; ++k) {
      masses.push_back(std::pow(10, 20 * uniform_sign(bits)));
      places.push_back({far + uniform_sign(bits), uniform_sign(bits), 1e-5 * uniform_sign(bits) - far});
    }
    const auto body = point_masses("points", masses, places);
    REQUIRE(body);
    std::array<std::vector<double>, 3> columns;
    Digits mass = 0;
    std::array<Digits, 3> centre{};
    for (std::size_t k = 0; k < masses.size(); ++k) {
      mass += masses[k];
      for (std::size_t i = 0; i < 3; ++i) {
        columns[i].push_back(places[k][i]);
        centre[i] += Digits(masses[k]) * places[k][i];
      }
    }
    check(*body, inertia_of(masses, columns));
    for (std::size_t i = 0; i < 3; ++i) {
      const ErrorBounds errors = place_errors(*body, i);
      for (std::size_t k = 0; k < masses.size(); ++k) {
        const double x = body->positions[i][k];
        CHECK(abs(places[k][i] - centre[i] / mass - x) <= errors.of(k, x));
      }
    }
  }
}

TEST_CASE("six particles are within their bounds of what has exactly the inertia that was given") {
  SplitMix bits(4);
  for (int n = 0; n < 200; ++n) {
    // Of points: it can be a body's; thin and flat ones among them, along the axes or not.
    std::array<std::vector<double>, 3> columns;
    std::vector<double> masses;
    const double thin = std::pow(10, -9 * uniform(bits));
    const double flat = bits.below(3) == 0 ? 0 : 1;
    for (int k = 0; k < 5; ++k) {
      masses.push_back(1 + uniform(bits));
      const double x = thin * uniform_sign(bits);
      const double y = flat * uniform_sign(bits);
      const double z = uniform_sign(bits);
      const bool turned = n % 2 == 0;
      columns[0].push_back(turned ? 0.6 * x - 0.8 * z : x);
      columns[1].push_back(y);
      columns[2].push_back(turned ? 0.8 * x + 0.6 * z : z);
    }
    const DigitsTensor of_points = inertia_of(masses, columns);
    InertiaTensor given{};
    DigitsTensor exact{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        given[i][j] = static_cast<double>(of_points[std::max(i, j)][std::min(i, j)]);
        exact[i][j] = given[i][j];
      }
    }
    const auto body = body_with_inertia("given", 3, given);
    if (!body) continue;  // rounded to what no body can have
    check(*body, exact);
    CHECK(inertia_error(*body) <= 200 * 0x1p-53 * 3 * (given[0][0] + given[1][1] + given[2][2]));
  }
}

TEST_CASE("shapes, and bodies of shapes along any axis, keep their bounds", "[body errors]") {
  const auto box = *quadrature_body("box", {ShapeKind::box, 0.9, {0.1, 0.7, 0.3}});
  const auto cone = *quadrature_body("cone", {ShapeKind::cone, 3, {0.1, 0.1, 0.3}});
  const auto exact = [](const std::array<Digits, 3>& squares, double mass) {
    DigitsTensor tensor{};
    for (std::size_t i = 0; i < 3; ++i) tensor[i][i] = mass * (squares[(i + 1) % 3] + squares[(i + 2) % 3]);
    return tensor;
  };
  const auto square = [](double x) { return Digits(x) * x; };
  const DigitsTensor of_box = exact({square(0.1) / 3, square(0.7) / 3, square(0.3) / 3}, 0.9);
  check(box, of_box);
  check(cone, exact({square(0.1) * 3 / 20, square(0.1) * 3 / 20, square(0.3) * 3 / 80}, 3));
  check(along_axis(box, 0), exact({square(0.3) / 3, square(0.1) / 3, square(0.7) / 3}, 0.9));
  check(along_axis(box, 1), exact({square(0.7) / 3, square(0.3) / 3, square(0.1) / 3}, 0.9));

  const Position at{1e8, 0.3, -7};
  const auto both = joined("both", {{box, {}}, {along_axis(box, 0), at}});
  REQUIRE(both);
  const DigitsTensor other = exact({square(0.3) / 3, square(0.1) / 3, square(0.7) / 3}, 0.9);
  DigitsTensor whole = inertia_of({0.9, 0.9}, {{{0, at[0]}, {0, at[1]}, {0, at[2]}}});
  for (std::size_t i = 0; i < 3; ++i) whole[i][i] += of_box[i][i] + other[i][i];
  check(*both, whole);
}

}  // namespace
}  // namespace rigor
