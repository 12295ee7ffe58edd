// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/exact/exact_moments.h"

#include <cmath>

#include "base/splitmix.h"
#include "catch.h"
#include "numeric/climb.h"
#include "numeric/exact/exact_tensor.h"
#include "numeric/kernels/jacobi_reference.h"
#include "numeric/kernels/mesh_families.h"
#include "numeric/kernels/solved_moments.h"
#include "numeric/meshes.h"
#include "numeric/program/uniform.h"

namespace rigor {
namespace {

using Digits = Decimal<700>;
using Rational = boost::multiprecision::cpp_rational;

Rational entry(const ExactTensor& tensor, std::size_t i, std::size_t j) {
  const Rational power = Integer(1) << std::abs(tensor.exponent);
  const Rational x(tensor.entries[i][j], tensor.divisor);
  return tensor.exponent < 0 ? Rational(x / power) : Rational(x * power);
}

InertiaTensor tensor_of(const Position& diagonal, const Position& off) {
  InertiaTensor tensor{};
  for (std::size_t i = 0; i < 3; ++i) {
    tensor[i][i] = diagonal[i];
    tensor[(i + 1) % 3][(i + 2) % 3] = tensor[(i + 2) % 3][(i + 1) % 3] = off[i];
  }
  return tensor;
}

Digits digits_of(const LongNumber& number) {
  Digits above = 0;
  Digits below = 0;
  for (const double part : number.parts) above += part;
  for (const double part : number.divisor) below += part;
  return above / below;
}

/// The greatest error of a moment over its bound, where 690 digits show any.
double beside_bound(const InertiaTensor& tensor) {
  const auto found = exact_moments(exact_tensor(tensor));
  REQUIRE(found);
  const std::array<Digits, 3> exact = JacobiReference<Digits>(tensor).moments;
  double worst = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Digits shown = Digits(found->moments[k].error) + abs(exact[2]) * Digits("1e-690");
    const Digits error = abs(digits_of(found->moments[k]) - exact[k]);
    worst = std::max(worst, static_cast<double>(Digits(error / shown)));
    if (k > 0) {
      const Digits gap = exact[k] - exact[k - 1];
      CHECK(abs(gap - found->principal.gaps[k - 1]) <= 0x1p-52 * gap + abs(exact[2]) * Digits("1e-690"));
    }
  }
  return worst;
}

TEST_CASE("moments that are equal are told exactly, and rational", "[exact]") {
  const auto isotropic = exact_moments(exact_tensor(tensor_of({0.3, 0.3, 0.3}, {})));
  REQUIRE(isotropic);
  CHECK(isotropic->principal.gaps == std::array<double, 2>{0, 0});
  CHECK(isotropic->moments[0].error == 0);
  CHECK(digits_of(isotropic->moments[1]) == Digits(0.3));
  // 2 1 − n n for n = (1, 1, 1): moments −1, 2, 2.
  const auto turned = exact_moments(exact_tensor(tensor_of({1, 1, 1}, {-1, -1, -1})));
  REQUIRE(turned);
  CHECK(turned->principal.gaps == std::array<double, 2>{3, 0});
  CHECK(digits_of(turned->moments[0]) == -1);
  CHECK(digits_of(turned->moments[2]) == 2);
  CHECK(std::abs(turned->axes[0][0]) == Approx(std::sqrt(1 / 3.)).epsilon(1e-15));
  const auto oblate = exact_moments(exact_tensor(tensor_of({2, 2, 5}, {})));
  REQUIRE(oblate);
  CHECK(oblate->principal.gaps == std::array<double, 2>{0, 3});
}

TEST_CASE("the axis of a moment beside two equal ones is found however near it is", "[exact]") {
  for (const double coupling : {1e-3, 1e-60, 1e-90, 1e-290}) {
    INFO(coupling);
    const auto found =
        exact_moments(exact_tensor(tensor_of({0.3, 0.3, 0.3}, {coupling, coupling, coupling})));
    REQUIRE(found);
    CHECK(found->principal.gaps[0] == 0);
    CHECK(found->principal.gaps[1] == Approx(3 * coupling).epsilon(1e-15));
    for (const double x : found->axes[2]) CHECK(std::abs(std::abs(x) - std::sqrt(1 / 3.)) < 1e-15);
  }
}

TEST_CASE("gaps that are not 0 have their digits, however small they are", "[exact]") {
  const auto found = exact_moments(exact_tensor(tensor_of({0.3, 0.3, 0.3}, {1e-78, 1e-83, 0})));
  REQUIRE(found);
  CHECK(found->principal.gaps[0] == Approx(1e-78).epsilon(1e-9));
  CHECK(found->principal.gaps[1] == Approx(1e-78).epsilon(1e-9));
  CHECK(beside_bound(tensor_of({0.3, 0.3, 0.3}, {1e-78, 1e-83, 0})) <= 1);
  CHECK(beside_bound(tensor_of({26, 31, 22}, {1e-76, 0, 6})) <= 1);
  CHECK(beside_bound(tensor_of({1, 1, 1}, {0, 0, 1e-280})) <= 1);
  // A moment that is 0 is 0, beside others that are not rational.
  const auto rod = exact_moments(exact_tensor(tensor_of({2, 3, 0}, {0, 0, 1})));
  REQUIRE(rod);
  CHECK(rod->moments[0].parts.empty());
  CHECK(rod->moments[0].error == 0);
  CHECK(rod->moments[1].error > 0);
}

TEST_CASE("a gap is 0 in the lanes where it is 0 in integers, and nowhere else", "[exact][moments]") {
  std::vector<MomentFamily> families = moment_families(96);
  MomentFamily coupled{"equal but for a coupling", {}};
  for (int power = 20; power < 250; ++power) {
    coupled.tensors.push_back(tensor_of({1, 1, 3}, {0, 0, std::ldexp(1, -power)}));
    coupled.tensors.push_back(tensor_of({26, 31, 22}, {std::ldexp(1, -power), 0, 6}));
  }
  families.push_back(coupled);
  std::size_t equal = 0;
  std::size_t close = 0;
  for (const MomentFamily& family : families) {
    SolvedMoments lanes(family.tensors);
    lane_kernels().principal_moments(lanes.columns);
    for (std::size_t at = 0; at < family.tensors.size(); ++at) {
      if (lanes.columns.state[at] != MomentsState::good) continue;
      const auto exact = exact_moments(exact_tensor(family.tensors[at]));
      if (!exact) continue;
      INFO(family.name << " " << at);
      const Digits size = abs(digits_of(exact->moments[0])) + abs(digits_of(exact->moments[2]));
      for (std::size_t k = 0; k < 3; ++k) {
        const Digits found = Digits(lanes.columns.moments[k][at]) + lanes.columns.moments_low[k][at];
        CHECK(abs(found - digits_of(exact->moments[k])) <=
              moments_error * size + exact->moments[k].error + 0x1p-1070);
      }
      for (std::size_t k = 0; k < 2; ++k) {
        const double gap = exact->principal.gaps[k];
        CHECK((lanes.columns.gaps[k][at] == 0) == (gap == 0));
        if (gap == 0) ++equal;
        if (gap > 0 && gap < 0x1p-50 * size) ++close;
      }
    }
  }
  CHECK(equal > 100);
  CHECK(close > 100);
}

TEST_CASE("climbing for the worst error of an exact moment ends below its bound", "[exact]") {
  SplitMix bits(3);
  const auto changed = [&](InertiaTensor tensor) {
    const std::size_t i = bits.below(3);
    const std::size_t j = bits.below(3);
    const double scale = std::pow(10, -60 * uniform(bits));
    const double entry = i == j ? 0.3 + scale * uniform_sign(bits) : scale * uniform_sign(bits);
    tensor[i][j] = tensor[j][i] = bits.below(4) == 0 ? (i == j ? 0.3 : 0) : entry;
    return tensor;
  };
  const double worst = climbed(tensor_of({0.3, 0.3, 0.3}, {}), 80, changed, beside_bound);
  CHECK(worst <= 1);
  CHECK(worst > 1e-6);  // so that the bound says something
}

TEST_CASE("points have the inertia of rational numbers about their centre", "[exact]") {
  SplitMix bits(4);
  std::vector<double> numbers;
  for (int k = 0; k < 20; ++k) {
    for (int i = 0; i < 3; ++i) numbers.push_back(uniform_sign(bits) * std::pow(10, 30 * uniform_sign(bits)));
    numbers.push_back(uniform(bits) * std::pow(10, 30 * uniform_sign(bits)));
  }
  const ExactTensor inertia = exact_body(point_records(numbers.data(), 20)).inertia;
  Rational mass = 0;
  std::array<Rational, 3> centre;
  for (std::size_t k = 0; k < 20; ++k) {
    mass += Rational(numbers[4 * k + 3]);
    for (std::size_t i = 0; i < 3; ++i)
      centre[i] += Rational(numbers[4 * k + 3]) * Rational(numbers[4 * k + i]);
  }
  std::array<std::array<Rational, 3>, 3> second;
  for (std::size_t k = 0; k < 20; ++k) {
    std::array<Rational, 3> r;
    for (std::size_t i = 0; i < 3; ++i) r[i] = Rational(numbers[4 * k + i]) - centre[i] / mass;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) second[i][j] += Rational(numbers[4 * k + 3]) * r[i] * r[j];
  }
  const Rational trace = second[0][0] + second[1][1] + second[2][2];
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      CHECK(entry(inertia, i, j) == (i == j ? Rational(trace - second[i][j]) : Rational(-second[i][j])));
}

TEST_CASE("bodies made of bodies have the inertia of all their points", "[exact]") {
  SplitMix bits(5);
  std::vector<double> all;
  std::vector<ExactBody> bodies;
  std::vector<Position> places;
  for (int part = 0; part < 3; ++part) {
    // Four points with their centre at 0 exactly: pairs of like masses.
    std::vector<double> own;
    const Position at{std::pow(10, 5 * uniform(bits)), uniform_sign(bits), 0x1p-30 * uniform_sign(bits)};
    for (int pair = 0; pair < 2; ++pair) {
      const double mass = uniform(bits) / 3;
      const Position x{static_cast<double>(bits.below(1000)), static_cast<double>(bits.below(1000)), 0};
      for (const double sign : {1., -1.}) {
        for (std::size_t i = 0; i < 3; ++i) own.push_back(sign * x[i]);
        own.push_back(mass);
      }
    }
    bodies.push_back(exact_body(point_records(own.data(), 4)));
    places.push_back({std::round(at[0]), std::round(at[1] * 1000), std::round(at[2] * 0x1p40)});
    for (std::size_t k = 0; k < own.size(); ++k)
      all.push_back(k % 4 == 3 ? own[k] : own[k] + places.back()[k % 4]);
  }
  std::vector<PlacedExactBody> parts;
  for (std::size_t k = 0; k < 3; ++k) parts.push_back({&bodies[k], places[k]});
  const ExactBody joined = exact_joined(parts);
  const ExactBody points = exact_body(point_records(all.data(), 12));
  CHECK(joined.mass == points.mass);
  CHECK(joined.mass_exponent == points.mass_exponent);
  const ExactBody turned = along_axis(joined, 1);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      CHECK(entry(joined.inertia, i, j) == entry(points.inertia, i, j));
      CHECK(entry(turned.inertia, (i + 1) % 3, (j + 1) % 3) == entry(joined.inertia, i, j));
    }
  }
}

TEST_CASE("what a mesh encloses has the moments of the faces' integrals", "[exact]") {
  Mesh mesh = shifted(sphere_mesh(1), 1e6);
  for (Position& vertex : mesh.vertices) vertex[1] *= 1e-3;
  const MeshReference reference = mesh_reference(mesh);
  for (const double unit : {1., 1e-3}) {
    const auto found = exact_solid(mesh);
    REQUIRE(found);
    const ExactSolid solid = times_unit(*found, unit);
    const ExactTensor inertia = inertia_with_mass(solid, 2.5);
    const ExactTensor of_density = inertia_with_density(solid, 2.5);
    const Digits100 volume = reference.volume * unit * unit * unit;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        Digits100 exact = i == j ? Digits100(0) : Digits100(-reference.second[i][j]);
        for (std::size_t k = 0; k < 3; ++k)
          if (i == j && k != i) exact += reference.second[k][k];
        exact *= Digits100(unit) * unit * 2.5;
        CHECK(abs(Digits100(entry(inertia, i, j)) - exact) <= abs(exact) * Digits100("1e-80"));
        CHECK(abs(Digits100(entry(of_density, i, j)) - exact * volume) <=
              abs(exact * volume) * Digits100("1e-80"));
      }
    }
  }
  CHECK(!exact_solid(
      {{{0, 0, 0}, {1e-200, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}}));
}

}  // namespace
}  // namespace rigor
