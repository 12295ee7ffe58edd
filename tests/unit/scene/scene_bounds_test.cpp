// SPDX-License-Identifier: GPL-3.0-or-later
// The bounds that scenes print, against the exact values for the points as they were given.
#include <algorithm>
#include <cmath>
#include <vector>

#include "base/splitmix.h"
#include "catch.h"
#include "numeric/body/bodies.h"
#include "numeric/kernels/moment_families.h"
#include "numeric/program/uniform.h"
#include "scene/played_scene.h"

namespace rigor {
namespace {

using Digits = Decimal<100>;
using DigitsTensor = std::array<std::array<Digits, 3>, 3>;

struct Points {
  std::vector<double> masses;
  std::vector<Position> places;

  void add(double mass, const Position& at) {
    masses.push_back(mass);
    places.push_back(at);
  }
  [[nodiscard]] Body body() const { return *point_masses("points", masses, places); }

  /// About their centre of mass.
  [[nodiscard]] DigitsTensor inertia() const {
    Digits mass = 0;
    std::array<Digits, 3> centre{};
    for (std::size_t k = 0; k < masses.size(); ++k) {
      mass += masses[k];
      for (std::size_t i = 0; i < 3; ++i) centre[i] += Digits(masses[k]) * places[k][i];
    }
    DigitsTensor inertia{};
    for (std::size_t k = 0; k < masses.size(); ++k) {
      std::array<Digits, 3> r;
      for (std::size_t i = 0; i < 3; ++i) r[i] = places[k][i] - centre[i] / mass;
      const Digits square = r[0] * r[0] + r[1] * r[1] + r[2] * r[2];
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          inertia[i][j] += masses[k] * ((i == j ? square : 0) - r[i] * r[j]);
    }
    return inertia;
  }
};

constexpr const char* all_of_it =
    "spin = [1, 2, 3]\nat = \"A thrown racket\"\naxes = \"principal\"\n[ask]\nerrors = true\nquantities = "
    "['(\\Omega_1)^2', '(\\Omega_2)^2', '(\\Omega_3)^2', 'principal moments', 'principal axes']\n";

/// What was printed holds for the moments I, in their order.
void check_frequencies(const Played& played, const std::array<Digits, 3>& moments) {
  const auto& shown = played.quantity("principal moments");
  REQUIRE(shown.error.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(abs(moments[i] - shown.value[i]) <= shown.error[i]);
    const Digits& j = moments[(i + 1) % 3];
    const Digits& k = moments[(i + 2) % 3];
    const double spin = static_cast<double>(i) + 1;
    const Digits exact = (moments[i] - j) * (moments[i] - k) / (j * k) * spin * spin;
    const auto& square = played.quantity("(\\Omega_" + std::to_string(i + 1) + ")^2");
    REQUIRE(square.error.size() == 1);
    INFO(i + 1 << ": " << square.value[0] << " ± " << square.error[0] << ", exactly " << exact);
    CHECK(abs(exact - square.value[0]) <= square.error[0]);
  }
}

TEST_CASE("a lattice that is isotropic exactly has frequencies of 0, and the bounds say so", "[scene]") {
  const double spacing = 0.1 * 3;
  Points lattice;
  for (int n = 0; n < 125; ++n)
    lattice.add(1, {spacing * (n % 5 - 2), spacing * (n / 5 % 5 - 2), spacing * (n / 25 - 2)});
  const Played played(all_of_it, lattice.body());
  CHECK(played.messages() == "");
  const DigitsTensor inertia = lattice.inertia();
  REQUIRE(inertia[0][0] == inertia[1][1]);
  check_frequencies(played, {inertia[0][0], inertia[0][0], inertia[0][0]});
  CHECK(played.quantity("(\\Omega_1)^2").error[0] <= 1e-45);
}

TEST_CASE("bounds of frequencies hold for points whose moments are alike to any digit", "[scene]") {
  SplitMix bits(9);
  for (int n = 0; n < 40; ++n) {
    // An octahedron, turned, with a speck, somewhere: what is to be told is the speck's.
    const double turn = 3 * uniform(bits);
    const double speck = std::pow(10, -32 * uniform(bits));
    const double far = n % 3 == 0 ? 0 : std::pow(10, 8 * uniform(bits));
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
    points.add(speck, place(uniform(bits), 0.3, uniform(bits)));
    const Played played(all_of_it, points.body());
    CHECK(played.messages() == "");
    const PrincipalReference exact = principal_reference_of_digits(points.inertia());
    // Where the body is along the axes of the file to 64 u, a moment belongs to the axis that its own is
    // nearest to; else they ascend.
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
    check_frequencies(played, in_order);
  }
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
    const PrincipalReference principal = principal_reference_of_digits(exact);
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
