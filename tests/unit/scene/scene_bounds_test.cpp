// SPDX-License-Identifier: GPL-3.0-or-later
// The bounds that scenes print, against the exact values for the points as they were given.
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/splitmix.h"
#include "catch.h"
#include "numeric/body/bodies.h"
#include "numeric/body/shapes.h"
#include "numeric/climb.h"
#include "numeric/kernels/jacobi_reference.h"
#include "numeric/meshes.h"
#include "numeric/program/uniform.h"
#include "scene/exact_points.h"
#include "scene/played_scene.h"

namespace rigor {
namespace {

using Digits = Digits200;
using Points = ExactPoints;

constexpr const char* all_of_it =
    "spin = [1, 2, 3]\nat = \"A thrown racket\"\naxes = \"principal\"\n[ask]\nerrors = true\nquantities = "
    "['(\\Omega_1)^2', '(\\Omega_2)^2', '(\\Omega_3)^2', 'principal moments', 'principal axes']\n";

/// The greatest part that the errors of what was printed take of their bounds, for the moments I, in their
/// order.
double worst_part(const Played& played, const std::array<Digits, 3>& moments) {
  const auto& shown = played.quantity("principal moments");
  REQUIRE(shown.error.size() == 3);
  double worst = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    worst = std::max(worst, part_of(moments[i] - shown.value[i], shown.error[i]));
    const Digits& j = moments[(i + 1) % 3];
    const Digits& k = moments[(i + 2) % 3];
    const double spin = static_cast<double>(i) + 1;
    const Digits exact = (moments[i] - j) * (moments[i] - k) / (j * k) * spin * spin;
    const auto& square = played.quantity("(\\Omega_" + std::to_string(i + 1) + ")^2");
    REQUIRE(square.error.size() == 1);
    INFO(i + 1 << ": " << square.value[0] << " ± " << square.error[0] << ", exactly " << exact);
    CHECK(part_of(exact - square.value[0], square.error[0]) <= 1);
    worst = std::max(worst, part_of(exact - square.value[0], square.error[0]));
  }
  CHECK(worst <= 1);
  return worst;
}

/// Where the body is along the axes of the file to 64 u, a moment belongs to the axis that its own is nearest
/// to; else they ascend.
std::array<Digits, 3> moments_in_order(const Points& points, const Played& played) {
  const JacobiReference<Digits> exact(points.inertia());
  const bool along =
      played.quantity("principal axes").value == std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1};
  std::array<Digits, 3> in_order{};
  std::array<bool, 3> taken{};
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t nearest = 3;
    for (std::size_t i = 0; i < 3; ++i)
      if (!taken[i] && (nearest == 3 || abs(exact.axes[k][i]) > abs(exact.axes[k][nearest]))) nearest = i;
    taken[nearest] = true;
    in_order[along ? nearest : k] = exact.moments[k];
  }
  return in_order;
}

/// All of what was printed tells its sign, or that it is 0.
void check_signs(const Played& played) {
  for (const char* square : {"(\\Omega_1)^2", "(\\Omega_2)^2", "(\\Omega_3)^2"})
    CHECK(!has_open_sign(played.quantity(square)));
}

Points lattice_of(double spacing) {
  Points lattice;
  for (int n = 0; n < 125; ++n)
    lattice.add(1, {spacing * (n % 5 - 2), spacing * (n / 5 % 5 - 2), spacing * (n / 25 - 2)});
  return lattice;
}

/// Turned about the third axis, with its centre at some distance along the first, and a speck.
struct Octahedron {
  double turn = 0;
  double far = 0;
  double speck = 0;
  Position at{};

  [[nodiscard]] Points points() const {
    Points points;
    const auto place = [&](double x, double y, double z) {
      return Position{std::cos(turn) * x - std::sin(turn) * y + far, std::sin(turn) * x + std::cos(turn) * y,
                      z};
    };
    for (const double sign : {1., -1.}) {
      points.add(1, place(sign, 0, 0));
      points.add(1, place(0, sign, 0));
      points.add(1, place(0, 0, sign));
    }
    points.add(speck, place(at[0], at[1], at[2]));
    return points;
  }
};

TEST_CASE("a lattice that is isotropic exactly has frequencies of 0, exactly", "[scene]") {
  const Played played(all_of_it, lattice_of(0.1 * 3).body());
  CHECK(played.messages() == "");
  for (const char* name : {"(\\Omega_1)^2", "(\\Omega_2)^2", "(\\Omega_3)^2"}) {
    CHECK(played.quantity(name).value == std::vector<double>{0});
    CHECK(played.quantity(name).error == std::vector<double>{0});
  }
}

TEST_CASE("where two axes are as near, the bound has both moments", "[scene]") {
  constexpr double speck = 0x1p-54;  // a product of inertia: the axes are 45 degrees from those of the file
  const Body body = *point_masses("octahedron", {1, 1, 1, 1, 1, 1},
                                  {{2, 0, 0}, {-2, 0, 0}, {0, 1, speck}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}});
  const Played played(all_of_it, body);
  const auto& moments = played.quantity("principal moments");
  REQUIRE(moments.error.size() == 3);
  CHECK(moments.value[1] == Approx(10));
  CHECK(moments.error[1] >= 0x1p-55);  // as far as they are apart
  CHECK(moments.error[2] >= 0x1p-55);
  CHECK(moments.value[0] == Approx(4));
  CHECK(moments.error[0] < 1e-25);  // no other is near this one
}

TEST_CASE("a lattice with one point off by its last place has frequencies that tell their signs", "[scene]") {
  Points lattice = lattice_of(0.1 * 3);
  lattice.places[8][0] = std::nextafter(lattice.places[8][0], 1);
  lattice.masses[30] = 1 - 0x1p-53;
  const Played played(all_of_it, lattice.body());
  worst_part(played, moments_in_order(lattice, played));
  check_signs(played);
}

TEST_CASE("a speck of 1e-29 kg beside a turned octahedron decides which spins are stable", "[scene]") {
  const Points points = Octahedron{.turn = 0.3, .speck = 1e-29, .at = {0.5, 0.3, 0.7}}.points();
  const Played played(all_of_it, points.body());
  worst_part(played, moments_in_order(points, played));
  check_signs(played);
  // Of three moments that differ, the spin about the middle one is the one that is not stable.
  int unstable = 0;
  for (const char* name : {"(\\Omega_1)^2", "(\\Omega_2)^2", "(\\Omega_3)^2"}) {
    const auto& square = played.quantity(name);
    CHECK(square.error[0] <= 0x1p-52 * std::abs(square.value[0]));
    unstable += square.value[0] < 0 ? 1 : 0;
  }
  CHECK(unstable == 1);
}

TEST_CASE("a frequency has its digits where no bound is asked for, too", "[scene]") {
  const Body body = Octahedron{.turn = 0.3, .speck = 1e-29, .at = {0.5, 0.3, 0.7}}.points().body();
  const Played played(
      "spin = [1, 2, 3]\nat = \"A thrown racket\"\naxes = \"principal\"\n[ask]\nquantities = "
      "['(\\Omega_1)^2', '(\\Omega_3)^2']\n",
      body);
  const Played bounded(all_of_it, body);
  for (const char* name : {"(\\Omega_1)^2", "(\\Omega_3)^2"}) {
    CHECK(played.value(name) == bounded.value(name));
    CHECK(played.quantity(name).error.empty());
  }
}

TEST_CASE("bounds of frequencies hold for points whose moments are alike to any digit", "[scene]") {
  SplitMix bits(9);
  for (int n = 0; n < 40; ++n) {
    const Points points = Octahedron{
        3 * uniform(bits),
        n % 3 == 0 ? 0 : std::pow(10, 8 * uniform(bits)),
        std::pow(10, -32 * uniform(bits)),
        {uniform(bits), 0.3,
         uniform(bits)}}.points();
    const Played played(all_of_it, points.body());
    CHECK(played.messages() == "");
    worst_part(played, moments_in_order(points, played));
    check_signs(played);
  }
}

TEST_CASE("climbing for the worst error of a printed frequency ends below its bound", "[scene]") {
  SplitMix bits(12);
  const auto changed = [&](Octahedron octahedron) {
    switch (bits.below(4)) {
      case 0:
        octahedron.turn = bits.below(3) == 0 ? 0 : 3 * uniform(bits);
        break;
      case 1:
        octahedron.far = bits.below(3) == 0 ? 0 : std::pow(10, 8 * uniform(bits));
        break;
      case 2:
        octahedron.speck = std::pow(10, -40 * uniform(bits));
        break;
      default:
        octahedron.at[bits.below(3)] = 2 * uniform_sign(bits);
    }
    return octahedron;
  };
  const auto badness = [](const Octahedron& octahedron) {
    const Points points = octahedron.points();
    const Played played(all_of_it, points.body());
    return worst_part(played, moments_in_order(points, played));
  };
  const double worst = climbed(Octahedron{.speck = 1e-10, .at = {1, 0, 0}}, 60, changed, badness);
  CHECK(worst <= 1);
  CHECK(worst > 0.01);  // so that the bounds say something
}

TEST_CASE("a cube's mesh, wherever it is, has frequencies of 0, and a longer box has none", "[scene]") {
  for (const Position& corner : {Position{}, Position{1e7, -3e6, 0.5}}) {
    const auto cube = mesh_mass(box_mesh({2, 2, 2}, corner), MeshSharpness::always);
    REQUIRE(cube);
    for (const auto& body : {mesh_body("cube", *cube, 0.1), mesh_body_of_density("cube", *cube, 0.1)}) {
      const Played played(all_of_it, *body);
      CHECK(played.quantity("(\\Omega_1)^2").value[0] == 0);
      CHECK(played.quantity("(\\Omega_1)^2").error[0] == 0);
    }
  }
  const auto box = mesh_mass(box_mesh({2, 2, 2 + 0x1p-51}, {}), MeshSharpness::always);
  REQUIRE(box);
  const Played played(all_of_it, *mesh_body("box", *box, 1));
  CHECK(played.quantity("(\\Omega_1)^2").value[0] == 0);
  CHECK(played.value("(\\Omega_3)^2") > 0);
  check_signs(played);
}

TEST_CASE("shapes of equal sides have frequencies of 0 exactly, along any axis", "[scene]") {
  const auto box = quadrature_body("box", {ShapeKind::box, 0.3, {0.15, 0.15, 0.05}});
  REQUIRE(box);
  for (const std::size_t axis : {0U, 1U, 2U}) {
    const Played played(all_of_it, along_axis(*box, axis));
    CHECK(played.quantity("(\\Omega_1)^2").error[0] <= 0x1p-51 * std::abs(played.value("(\\Omega_1)^2")));
    check_signs(played);
    const std::string along = "(\\Omega_" + std::to_string(axis + 1) + ")^2";
    for (const char* name : {"(\\Omega_1)^2", "(\\Omega_2)^2", "(\\Omega_3)^2"}) {
      if (name == along)
        CHECK(played.value(name) > 0);
      else
        CHECK(played.value(name) == 0);
    }
  }
}

TEST_CASE("a dumbbell of two spheres and a rod is symmetric exactly, and one with a speck is not",
          "[scene]") {
  const auto sphere = quadrature_body("sphere", {ShapeKind::sphere, 0.7, {0.1, 0.1, 0.1}});
  const auto rod = quadrature_body("rod", {ShapeKind::rod, 0.3, {0, 0, 0.45}});
  REQUIRE((sphere && rod));
  std::vector<PlacedBody> parts{{*sphere, {3, 0.1, 0.55}}, {*rod, {3, 0.1, 0}}, {*sphere, {3, 0.1, -0.55}}};
  const Played played(all_of_it, *joined("dumbbell", parts));
  CHECK(played.quantity("(\\Omega_1)^2").value[0] == 0);
  CHECK(played.quantity("(\\Omega_1)^2").error[0] == 0);
  CHECK(played.value("(\\Omega_3)^2") > 0);
  check_signs(played);
  parts.push_back({*point_masses("speck", {1e-33}, {{}}), {3.5, 0.1, 0}});
  const Played with_speck(all_of_it, *joined("dumbbell", parts));
  CHECK(with_speck.value("(\\Omega_1)^2") != 0);
  check_signs(with_speck);
}

TEST_CASE("a tensor that a file gives has the gaps that its numbers have", "[scene]") {
  const InertiaTensor alike{{{0.3, 0, 1e-83}, {0, 0.3, 1e-78}, {1e-83, 1e-78, 0.3}}};
  const Played played(all_of_it, *body_with_inertia("alike", 1, alike));
  CHECK(played.value("(\\Omega_1)^2") == Approx(-1e-156 / 0.09).epsilon(1e-9));
  check_signs(played);
  const InertiaTensor coupled{{{26, 6, 0}, {6, 31, 1e-76}, {0, 1e-76, 22}}};
  const Played turned(all_of_it, *body_with_inertia("coupled", 1, coupled));
  check_signs(turned);
  // Moments 22 ∓ g, g = 1e-76·2/√13 of the block's axis (3, −2)/√13 by which 22 is coupled.
  const double gap = 2e-76 * 2 / std::sqrt(13.);
  CHECK(turned.value("(\\Omega_1)^2") == Approx(gap * 13 / (22 * 35)).epsilon(1e-9));
  CHECK(turned.value("(\\Omega_2)^2") == Approx(-4 * gap * 13 / (22 * 35)).epsilon(1e-9));
  CHECK(turned.quantity("principal axes").error[0] <= 1e-14);
}

TEST_CASE("bounds of energies and tensors hold for the points before they were moved", "[scene]") {
  SplitMix bits(10);
  for (int n = 0; n < 30; ++n) {
    Points points;
    const double far = std::pow(10, 10 * uniform(bits));
    for (int k = 0; k < 6; ++k)
      points.add(std::pow(10, 12 * uniform_sign(bits)),
                 {far + uniform_sign(bits), uniform_sign(bits), 1e-3 * uniform_sign(bits) + far});
    const Played played(
        "spin = [0.1, 0.2, 0.3]\naxes = \"body\"\n[ask]\nerrors = true\nquantities = ['T_{rot}', 'I_{ij}']\n",
        points.body());
    CHECK(played.messages() == "");
    const DigitsTensor exact = points.inertia();
    const auto& tensor = played.quantity("I_{ij}");
    const auto& energy = played.quantity("T_{rot}");
    REQUIRE(tensor.error.size() == 9);
    REQUIRE(energy.error.size() == 1);
    const Position spin{0.1, 0.2, 0.3};
    Digits twice = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        twice += exact[i][j] * spin[i] * spin[j];
        CHECK(abs(exact[i][j] - tensor.value[3 * i + j]) <= tensor.error[3 * i + j]);
      }
    }
    CHECK(abs(twice / 2 - energy.value[0]) <= energy.error[0]);
    CHECK(energy.error[0] <= 1e-13 * energy.value[0]);
  }
}

TEST_CASE("bounds hold for an energy in principal moments of a body that is turned", "[scene]") {
  SplitMix bits(11);
  for (int n = 0; n < 30; ++n) {
    Points points;
    for (int k = 0; k < 5; ++k)
      points.add(1 + uniform(bits), {3 * uniform_sign(bits), uniform_sign(bits), 2 * uniform_sign(bits)});
    const Played played(
        "spin = [0.1, 0.2, 0.3]\naxes = \"body\"\nat = \"A thrown racket\"\n[ask]\nerrors = true\nquantities "
        "= "
        "['T_{rot}', 'I_1', 'principal axes']\n",
        points.body());
    CHECK(played.messages() == "");
    const DigitsTensor exact = points.inertia();
    const JacobiReference<Digits> principal(exact);
    const auto& axes = played.quantity("principal axes");
    REQUIRE(axes.error.size() == 9);
    for (std::size_t k = 0; k < 3; ++k) {
      Digits along = 0;
      for (std::size_t i = 0; i < 3; ++i) along += principal.axes[k][i] * axes.value[3 * k + i];
      for (std::size_t i = 0; i < 3; ++i)
        CHECK(abs((along < 0 ? -1 : 1) * principal.axes[k][i] - axes.value[3 * k + i]) <=
              axes.error[3 * k + i]);
    }
    CHECK(abs(principal.moments[0] - played.value("I_1")) <= played.quantity("I_1").error.at(0));
    const Position spin{0.1, 0.2, 0.3};
    Digits twice = 0;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) twice += exact[i][j] * spin[i] * spin[j];
    const auto& energy = played.quantity("T_{rot}");
    CHECK(abs(twice / 2 - energy.value[0]) <= energy.error.at(0));
    CHECK(energy.error[0] <= 1e-12 * energy.value[0]);
  }
}

TEST_CASE("where no bound is known, none is printed", "[scene]") {
  const Played played(
      "spin = [1, 2, 3]\nat = \"A thrown racket\"\naxes = \"principal\"\n[values]\n'\\boldsymbol{\\tau}' = "
      "[0, "
      "0, 0]\n[motion]\nequations = \"(22)\"\nduration = \"1 s\"\n[ask]\nerrors = true\nquantities = "
      "['\\dot{\\boldsymbol{\\omega}}']\n",
      *body_with_inertia("given", 1, {{{1, 0, 0}, {0, 2, 0}, {0, 0, 2.5}}}));
  const auto& rates = played.quantity("\\dot{\\boldsymbol{\\omega}}");
  REQUIRE(rates.error.size() == 3);
  CHECK(std::isinf(rates.error[0]));
}

}  // namespace
}  // namespace rigor
