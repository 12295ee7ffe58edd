// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/mesh/mesh_parts.h"

#include <algorithm>
#include <cmath>

#include "base/splitmix.h"
#include "catch.h"
#include "numeric/climb.h"
#include "numeric/kernels/mesh_families.h"
#include "numeric/meshes.h"
#include "numeric/program/uniform.h"

namespace rigor {
namespace {

constexpr double u = 0x1p-53;

void append(Mesh& mesh, const Mesh& part, bool inside_out = false) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), part.vertices.begin(), part.vertices.end());
  for (auto triangle : part.triangles) {
    for (std::uint32_t& corner : triangle) corner += first;
    if (inside_out) std::swap(triangle[0], triangle[1]);
    mesh.triangles.push_back(triangle);
  }
}

/// With half edges h.
Mesh cube_at(double h, const Position& centre) {
  Position corner = centre;
  for (double& x : corner) x -= h;
  return box_mesh({2 * h, 2 * h, 2 * h}, corner);
}

Mesh placed(Mesh mesh, double size, const Position& at) {
  for (Position& vertex : mesh.vertices)
    for (std::size_t i = 0; i < 3; ++i) vertex[i] = vertex[i] * size + at[i];
  return mesh;
}

struct Checked {
  double greatest = 0;  // error of a second moment beside √(ii jj)
  double promised = 0;  // the bound of it
  double part = 0;      // the greatest that an error of high + low takes of its bound
};

/// Every bound of the result holds, low parts included, and the doubles alone are right to 3 u.
Checked check(const Mesh& mesh) {
  const MeshReference exact = mesh_reference(mesh);
  const auto mass = mesh_mass(mesh, MeshSharpness::always);
  INFO((mass ? "" : mass.error().reason));
  REQUIRE(mass);
  const double volume = static_cast<double>(abs(exact.volume));
  CHECK(std::abs(mass->volume - volume) <= mass->volume_error * volume + 4 * u * volume);
  Checked checked;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const double size = static_cast<double>(Digits100(sqrt(exact.second[i][i] * exact.second[j][j])));
      const Digits100 sharp = Digits100(mass->second_moments[i][j]) + mass->low[i][j];
      const Digits100 sharp_error = abs(sharp - exact.second[i][j]);
      CHECK(sharp_error <= mass->error);
      checked.part = std::max(checked.part, static_cast<double>(Digits100(sharp_error / mass->error)));
      const auto error = static_cast<double>(Digits100(abs(mass->second_moments[i][j] - exact.second[i][j])));
      CHECK(error <= 3 * u * size);
      checked.greatest = std::max(checked.greatest, error / size);
      checked.promised = std::max(checked.promised, mass->error / size);
    }
  }
  return checked;
}

/// The same surface with its vertices and triangles in another order, and other corners first.
Mesh shuffled(const Mesh& mesh, SplitMix& bits) {
  Mesh other = mesh;
  std::vector<std::uint32_t> place(mesh.vertices.size());
  for (std::uint32_t n = 0; n < place.size(); ++n) place[n] = n;
  for (std::size_t n = place.size(); n > 1; --n) std::swap(place[n - 1], place[bits.below(n)]);
  for (std::size_t n = 0; n < place.size(); ++n) other.vertices[place[n]] = mesh.vertices[n];
  for (auto& triangle : other.triangles) {
    for (std::uint32_t& corner : triangle) corner = place[corner];
    std::ranges::rotate(triangle, triangle.begin() + static_cast<std::ptrdiff_t>(bits.below(3)));
  }
  for (std::size_t n = other.triangles.size(); n > 1; --n)
    std::swap(other.triangles[n - 1], other.triangles[bits.below(n)]);
  return other;
}

TEST_CASE("two cubes, a speck far from a large one, have the second moments of two cubes", "[mesh]") {
  for (const bool speck_first : {false, true}) {
    Mesh mesh;
    const Mesh cube = cube_at(1, {});
    const Mesh speck = cube_at(1e-4, {1e7, -1e7, 3e6});
    append(mesh, speck_first ? speck : cube);
    append(mesh, speck_first ? cube : speck);
    check(mesh);
    const auto mass = mesh_mass(mesh);
    REQUIRE(mass);
    const double moment = mass->second_moments[1][1] + mass->second_moments[2][2];
    CHECK(moment == Approx(109.0 + 2 / 3.0).epsilon(1e-5));  // the speck's corners are rounded
    const auto whole = mesh_moments(mesh.vertices, mesh.triangles, MeshSharpness::always);
    CHECK(!whole);  // about one point nothing is known of the speck
  }
}

TEST_CASE("the order of corners, triangles and parts changes no more than the bounds allow", "[mesh]") {
  SplitMix bits(6);
  Mesh mesh = cube_at(1, {});
  append(mesh, cube_at(1e-4, {1e7, -1e7, 3e6}));
  for (int n = 0; n < 40; ++n) {
    const Mesh other = shuffled(mesh, bits);
    check(other);
    const auto mass = mesh_mass(other);
    REQUIRE(mass);
    CHECK(mass->second_moments[1][1] + mass->second_moments[2][2] == Approx(109.0 + 2 / 3.0).epsilon(1e-5));
  }
}

TEST_CASE("climbing for the worst error of a mesh of parts ends below its bound", "[mesh]") {
  SplitMix bits(7);
  struct PlacedPart {
    double size = 1;
    Position at{};
  };
  using PlacedParts = std::array<PlacedPart, 3>;
  const auto changed = [&](PlacedParts parts) {
    PlacedPart& part = parts[bits.below(3)];
    if (bits.below(2) == 0)
      part.size = std::pow(10, -5 * uniform(bits));
    else
      part.at[bits.below(3)] = std::pow(10, 9 * uniform(bits)) * uniform_sign(bits);
    return parts;
  };
  const auto badness = [&](const PlacedParts& parts) {
    Mesh mesh;
    for (const PlacedPart& part : parts) append(mesh, placed(tetrahedron_mesh(), part.size, part.at));
    return check(shuffled(mesh, bits)).part;
  };
  const PlacedParts start{{{1, {}}, {1e-4, {1e7, -1e7, 3e6}}, {1, {5, 0, 0}}}};
  const double worst = climbed(start, 300, changed, badness);
  CHECK(worst <= 1);
  CHECK(worst > 1e-4);  // so that the bound says something
}

TEST_CASE("parts of any sizes anywhere keep the bounds that come with them", "[mesh]") {
  SplitMix bits(5);
  const auto power = [&](double least, double most) {
    return std::pow(10, least + (most - least) * uniform(bits));
  };
  double worst = 0;
  for (int n = 0; n < 80; ++n) {
    Mesh mesh;
    const std::uint64_t parts = 2 + bits.below(4);
    for (std::uint64_t k = 0; k < parts; ++k) {
      const double away = power(0, 9);
      const Position at{away * uniform_sign(bits) + 4 * static_cast<double>(k), away * uniform_sign(bits),
                        away * uniform_sign(bits)};
      const Mesh& shape = bits.below(2) == 0 ? tetrahedron_mesh() : sphere_mesh(2);
      append(mesh, placed(shape, power(-5, 1), at));
    }
    worst = std::max(worst, check(mesh).greatest);
  }
  CHECK(worst > 0.5 * u);  // so that 3 u says something
}

TEST_CASE("a cavity is taken away, in a thin shell too", "[mesh]") {
  for (const double thickness : {0.5, 1e-3, 1e-6}) {
    Mesh mesh = placed(sphere_mesh(3), 1, {1e6, 0, -2e5});
    append(mesh, placed(sphere_mesh(3), 1 - thickness, {1e6, 0, -2e5}), true);
    append(mesh, placed(sphere_mesh(1), 1e-3, {1e6, 3e8, 0}));
    check(mesh);
  }
}

TEST_CASE("thin bodies have the second moments that they have, to all digits", "[mesh]") {
  int thin = 0;
  for (const MeshFamily& family : mesh_families(500)) {
    if (family.name.find("thickness 1e-8") == std::string::npos) continue;
    for (const Mesh& mesh : family.meshes) {
      check(mesh);
      ++thin;
    }
  }
  CHECK(thin > 3);
}

TEST_CASE("a sheet that is flat but for rounding is refused", "[mesh]") {
  SplitMix bits(8);
  for (int n = 0; n < 20; ++n) {
    Mesh sheet = sphere_mesh(2);
    const double a = uniform_sign(bits);
    const double b = uniform_sign(bits);
    for (Position& vertex : sheet.vertices) vertex[2] = a * vertex[0] + b * vertex[1];
    CHECK(!mesh_mass(sheet, MeshSharpness::always));
  }
}

TEST_CASE("parts are those that share vertices, in the order of their triangles", "[mesh]") {
  Mesh mesh = tetrahedron_mesh();
  append(mesh, cube_at(1, {5, 5, 5}));
  const auto parts = connected_parts(mesh);
  REQUIRE(parts.size() == 2);
  CHECK(parts[0].vertices.size() == 4);
  CHECK(parts[1].vertices.size() == 8);
  CHECK(parts[1].triangles.size() == 12);
  CHECK(mesh_mass(parts[1])->centre == Position{5, 5, 5});
}

TEST_CASE("a part inside out that is larger than the rest is refused, and so is a part lost in its box") {
  Mesh mesh = cube_at(1, {});
  append(mesh, cube_at(0.9, {1e9, 0, 0}), true);
  const auto mass = mesh_mass(mesh);
  REQUIRE(!mass);
  CHECK(mass.error().reason ==
        "the second moments are not positive: the surface passes through itself, or one of several is "
        "turned inside out");
  // A needle in one part, from a cube to a speck: V is 1e-29 of the box.
  Mesh needle{{{0, 0, 0}, {1e-10, 0, 0}, {0, 1e-10, 0}, {1e9, 1e9, 1e9}},
              {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}};
  const auto lost = mesh_mass(needle);
  REQUIRE(!lost);
}

}  // namespace
}  // namespace rigor
