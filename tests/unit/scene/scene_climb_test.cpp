// SPDX-License-Identifier: GPL-3.0-or-later
// The bounds that scenes print for energies and tensors, against the worst bodies that a search finds.
#include <cmath>

#include "base/splitmix.h"
#include "catch.h"
#include "numeric/body/bodies.h"
#include "numeric/climb.h"
#include "numeric/kernels/mesh_families.h"
#include "numeric/meshes.h"
#include "numeric/program/uniform.h"
#include "scene/exact_points.h"
#include "scene/played_scene.h"

namespace rigor {
namespace {

constexpr Position given_spin{0.1, 0.2, 0.3};

/// The greatest part that the errors of the tensor and of the energy take of their bounds.
double worst_part(const Body& body, const DigitsTensor& exact) {
  const Played played(
      "spin = [0.1, 0.2, 0.3]\naxes = \"body\"\n[ask]\nerrors = true\nquantities = ['T_{rot}', 'I_{ij}']\n",
      body);
  CHECK(played.messages() == "");
  const auto& tensor = played.quantity("I_{ij}");
  const auto& energy = played.quantity("T_{rot}");
  REQUIRE(tensor.error.size() == 9);
  REQUIRE(energy.error.size() == 1);
  double worst = 0;
  Digits200 twice = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      twice += exact[i][j] * given_spin[i] * given_spin[j];
      const double part = part_of(exact[i][j] - tensor.value[3 * i + j], tensor.error[3 * i + j]);
      INFO("I_" << i + 1 << j + 1 << " = " << tensor.value[3 * i + j] << " ± " << tensor.error[3 * i + j]);
      CHECK(part <= 1);
      worst = std::max(worst, part);
    }
  }
  const double part = part_of(twice / 2 - energy.value[0], energy.error[0]);
  INFO("T = " << energy.value[0] << " ± " << energy.error[0]);
  CHECK(part <= 1);
  return std::max(worst, part);
}

TEST_CASE("climbing for the worst error of a cloud's energy and tensor ends below their bounds", "[scene]") {
  SplitMix bits(13);
  ExactPoints start;
  for (int k = 0; k < 5; ++k) start.add(1, {uniform_sign(bits), uniform_sign(bits), uniform_sign(bits)});
  const auto changed = [&](ExactPoints points) {
    const std::size_t i = bits.below(3);
    const double size = std::pow(10, 10 * uniform_sign(bits));
    switch (bits.below(3)) {
      case 0:
        for (Position& place : points.places) place[i] += size;
        break;
      case 1:
        points.masses[bits.below(5)] = size;
        break;
      default:
        points.places[bits.below(5)][i] = size * uniform_sign(bits);
    }
    return points;
  };
  const auto badness = [](const ExactPoints& points) { return worst_part(points.body(), points.inertia()); };
  const double worst = climbed(start, 100, changed, badness);
  CHECK(worst <= 1);
  CHECK(worst > 0.01);  // so that the bounds say something
}

TEST_CASE("climbing for the worst error of bodies made of bodies ends below their bounds", "[scene]") {
  SplitMix bits(14);
  using Places = std::array<Position, 3>;
  const auto changed = [&](Places places) {
    places[bits.below(3)][bits.below(3)] = std::pow(10, 8 * uniform_sign(bits)) * uniform_sign(bits);
    return places;
  };
  const auto badness = [](const Places& places) {
    std::vector<PlacedBody> parts;
    ExactPoints points;
    for (const Position& place : places) {
      // Two points of 1 kg at ±1/3 along x and of 1/4 kg at ±1/2 along y, so that no part has a middle of its
      // own to find.
      parts.push_back({*point_masses("part", {1, 1, 0.25, 0.25},
                                     {{1 / 3., 0, 0}, {-1 / 3., 0, 0}, {0, 0.5, 0}, {0, -0.5, 0}}),
                       place});
    }
    const auto body = joined("whole", parts);
    REQUIRE(body);
    DigitsTensor exact{};
    const DigitsTensor own =
        ExactPoints{{1, 1, 0.25, 0.25}, {{1 / 3., 0, 0}, {-1 / 3., 0, 0}, {0, 0.5, 0}, {0, -0.5, 0}}}
            .inertia();
    for (const Position& place : places) points.add(2.5, place);
    const DigitsTensor between = points.inertia();
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) exact[i][j] = 3 * own[i][j] + between[i][j];
    return worst_part(*body, exact);
  };
  const double worst = climbed(Places{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 60, changed, badness);
  CHECK(worst <= 1);
  CHECK(worst > 0.01);
}

TEST_CASE("climbing for the worst error of a mesh's energy and tensor ends below their bounds", "[scene]") {
  SplitMix bits(15);
  struct PlacedSpeck {
    double size = 1e-4;
    Position at{1e7, -1e7, 3e6};
    double mass = 1;
  };
  const auto changed = [&](PlacedSpeck speck) {
    switch (bits.below(3)) {
      case 0:
        speck.size = std::pow(10, -5 * uniform(bits));
        break;
      case 1:
        speck.at[bits.below(3)] = std::pow(10, 8 * uniform(bits)) * uniform_sign(bits);
        break;
      default:
        speck.mass = 1 + uniform(bits);
    }
    return speck;
  };
  const auto badness = [](const PlacedSpeck& speck) {
    Mesh mesh = box_mesh({2, 2, 2}, {-1, -1, -1});
    const Mesh part = tetrahedron_mesh();
    for (const Position& vertex : part.vertices) {
      mesh.vertices.push_back(speck.at);
      for (std::size_t i = 0; i < 3; ++i) mesh.vertices.back()[i] += speck.size * vertex[i];
    }
    for (auto triangle : part.triangles) {
      for (std::uint32_t& corner : triangle) corner += 8;
      mesh.triangles.push_back(triangle);
    }
    const auto mass = mesh_mass(mesh, MeshSharpness::always);
    if (!mass) return 0.0;  // a speck whose corners coincide
    const MeshReference exact = mesh_reference(mesh);
    DigitsTensor inertia{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      inertia[i][i] = (Digits200(exact.second[j][j]) + Digits200(exact.second[k][k])) * speck.mass;
      inertia[i][j] = inertia[j][i] = Digits200(-exact.second[i][j]) * speck.mass;
    }
    return worst_part(*mesh_body("body", *mass, speck.mass), inertia);
  };
  const double worst = climbed(PlacedSpeck{}, 60, changed, badness);
  CHECK(worst <= 1);
  CHECK(worst > 0.001);
}

}  // namespace
}  // namespace rigor
