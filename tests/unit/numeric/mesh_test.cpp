// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/mesh/mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "catch.h"
#include "numeric/body/inertia.h"
#include "numeric/meshes.h"

namespace rigor {
namespace {

constexpr double u = 0x1p-53;

std::string reason(const Mesh& mesh) {
  const auto mass = mesh_mass(mesh);
  return mass ? "accepted" : mass.error().reason;
}

TEST_CASE("a box has the volume, centre and second moments of a box, at any distance from the origin") {
  for (const double distance : {0.0, 0x1p13, 0x1p26}) {
    const auto mass = mesh_mass(box_mesh({1, 2, 4}, {distance, distance, distance}));
    REQUIRE(mass);
    const double digits = 64 * u;  // all coordinates are exact
    CHECK(std::abs(mass->volume - 8) <= digits * 8);
    const Position sides{1, 2, 4};
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(std::abs(mass->centre[i] - (distance + sides[i] / 2)) <= digits * 4 + 2 * u * distance);
      for (std::size_t j = 0; j < 3; ++j) {
        const double exact = i == j ? sides[i] * sides[i] / 12 : 0;
        CHECK(std::abs(mass->second_moments[i][j] - exact) <= digits * sides[i] * sides[j]);
      }
    }
    CHECK_FALSE(mass->turned);
    CHECK(mass->degenerate == 0);
  }
}

TEST_CASE("a corner tetrahedron has products of inertia") {
  const auto mass = mesh_mass(tetrahedron_mesh());
  REQUIRE(mass);
  CHECK(mass->volume == Approx(1. / 6).epsilon(8 * u));
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(mass->centre[i] == Approx(0.25).epsilon(8 * u));
    // ∫x² dV / V = 1/10, ∫xy dV / V = 1/20, and 1/16 less about the centre.
    for (std::size_t j = 0; j < 3; ++j)
      CHECK(std::abs(mass->second_moments[i][j] - ((i == j ? 0.1 : 0.05) - 0.0625)) <= 16 * u);
  }
}

TEST_CASE("a fine sphere comes near the ball, as the square of its edges, and keeps its digits far away") {
  const double ball = 4 * std::numbers::pi / 3;
  double before = 0;
  for (int times = 1; times <= 4; ++times) {
    const double missing = ball - mesh_mass(sphere_mesh(times))->volume;
    CHECK(missing > 0);
    if (times > 2) CHECK(before / missing == Approx(4).epsilon(0.15));
    before = missing;
  }
  const auto near = mesh_mass(sphere_mesh(4));
  const auto far = mesh_mass(shifted(sphere_mesh(4), 1e4));
  CHECK(near->second_moments[0][0] == Approx(0.2).epsilon(0.01));
  // The coordinates themselves have lost 1e4 u.
  CHECK(std::abs(far->volume - near->volume) <= 3 * 1e4 * 2 * u * near->volume);
  CHECK(std::abs(far->second_moments[0][0] - near->second_moments[0][0]) <= 1e4 * 8 * u);
}

TEST_CASE("six particles have the mass, centre and inertia of a mesh") {
  for (const Mesh& mesh : {tetrahedron_mesh(), box_mesh({3, 2, 1}, {5, 5, 5}), sphere_mesh(2)}) {
    const auto enclosed = mesh_mass(mesh);
    const auto body = mesh_body("body", *enclosed, 2.5);
    REQUIRE(body);
    CHECK(body->size() == 6);
    CHECK(total_mass(*body) == Approx(2.5).epsilon(8 * u));
    const InertiaTensor inertia = *inertia_tensor(*body);
    CHECK(check_inertia(body->known->inertia));
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK(std::abs((*sharp_centre_of_mass(points_of(*body)))[i].high) <= 8 * u);
      for (std::size_t j = 0; j < 3; ++j)
        CHECK(std::abs(inertia[i][j] - body->known->inertia[i][j]) <= 64 * u * body->known->inertia[2][2]);
    }
  }
  const auto box = mesh_body("box", *mesh_mass(box_mesh({3, 2, 1}, {0, 0, 0})), 12);
  CHECK(box->known->inertia[0][0] == Approx(5).epsilon(64 * u));
  CHECK(box->known->inertia[2][2] == Approx(13).epsilon(64 * u));
}

TEST_CASE("a surface with a hole is refused with an edge of the hole") {
  Mesh mesh = tetrahedron_mesh();
  mesh.triangles.pop_back();
  CHECK(reason(mesh) ==
        "the edge from (0, 0, 1) to (0, 1, 0) belongs to one triangle only: the surface is open");
  CHECK(reason({}) == "the mesh has no triangles");
}

TEST_CASE("one triangle that is turned is refused, and where all are, they are turned back") {
  Mesh mesh = box_mesh({1, 1, 1}, {0, 0, 0});
  std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
  CHECK(reason(mesh) ==
        "the edge from (0, 0, 0) to (0, 0, 1) is passed twice in the same direction: the triangles are not "
        "oriented alike");
  mesh = tetrahedron_mesh();
  for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  const auto turned = mesh_mass(mesh);
  REQUIRE(turned);
  CHECK(turned->turned);
  CHECK(turned->volume == Approx(1. / 6));
  CHECK(turned->second_moments[0][0] == Approx(0.1 - 0.0625));
}

TEST_CASE("an edge of four triangles is refused") {
  Mesh mesh = box_mesh({1, 1, 1}, {0, 0, 0});
  const Mesh other = box_mesh({1, 1, 1}, {1, 1, 0});
  for (auto triangle : other.triangles) {
    for (std::uint32_t& corner : triangle) corner += 8;
    mesh.triangles.push_back(triangle);
  }
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  CHECK(reason(mesh) == "the edge from (1, 1, 0) to (1, 1, 1) belongs to 4 triangles, not to two");
}

TEST_CASE("a flat mesh encloses no volume, and a thin one does") {
  Mesh flat = tetrahedron_mesh();
  for (Position& vertex : flat.vertices) vertex[2] = vertex[0] + vertex[1];
  flat.vertices[3] = {0.3, 0.3, 0.6};
  CHECK(reason(flat) == "the mesh encloses no volume");
  CHECK(mesh_mass(box_mesh({1, 1, 1e-8}, {0, 0, 0}))->volume == Approx(1e-8).epsilon(1e-7));
  CHECK(reason(box_mesh({1e200, 1e200, 1e200}, {0, 0, 0})) == "the volume overflows");
}

TEST_CASE("triangles without an area are counted and do no harm") {
  Mesh mesh = tetrahedron_mesh();
  mesh.triangles.push_back({1, 1, 2});
  // The edge 1 2 is cut in its middle on one side: the triangle 1 m 2 closes the gap.
  mesh.vertices.push_back({0.5, 0.5, 0});
  mesh.triangles[0] = {0, 4, 1};
  mesh.triangles.push_back({0, 2, 4});
  mesh.triangles.push_back({1, 4, 2});
  const auto mass = mesh_mass(mesh);
  REQUIRE(mass);
  CHECK(mass->degenerate == 2);
  CHECK(mass->volume == Approx(1. / 6).epsilon(16 * u));
}

TEST_CASE("vertices at the same place are one, and those that no triangle has are nowhere") {
  const Mesh box = box_mesh({1, 2, 4}, {0, 0, 0});
  Mesh soup;
  for (const auto& triangle : box.triangles) {
    for (const std::uint32_t corner : triangle) soup.vertices.push_back(box.vertices[corner]);
    const auto size = static_cast<std::uint32_t>(soup.vertices.size());
    soup.triangles.push_back({size - 3, size - 2, size - 1});
  }
  soup.vertices[0][0] = -0.0;
  soup.vertices.push_back({1e15, 0, 0});
  REQUIRE(welded(soup));
  CHECK(welded(soup)->vertices.size() == 8);
  CHECK(mesh_mass(soup)->volume == Approx(8).epsilon(64 * u));
}

TEST_CASE("corners that are no vertices are refused before anything is read at them") {
  for (const std::uint32_t corner : {4U, 5U, 0x7fffffffU, 0x80000000U, 4'000'000'000U, 0xffffffffU}) {
    Mesh mesh = tetrahedron_mesh();
    mesh.triangles[2][1] = corner;
    const std::string refused =
        "triangle 3 has the vertex " + std::to_string(std::uint64_t{corner} + 1) + " of 4";
    CHECK(reason(mesh) == refused);
    REQUIRE_FALSE(welded(mesh));
    CHECK(welded(mesh).error().reason == refused);
    REQUIRE_FALSE(check_closed(mesh));
    CHECK(check_closed(mesh).error().reason == refused);
  }
  CHECK(reason({{}, {{0, 1, 2}}}) == "the mesh has 0 vertices");
}

// Equal places are looked for along chains, which would grow by one for each NaN: 18 s for these.
TEST_CASE("vertices that are not finite are refused by their number, however many there are") {
  Mesh mesh = tetrahedron_mesh();
  mesh.vertices.resize(200'000, {1, std::nan(""), 2});
  CHECK(reason(mesh) == "vertex 5 is at (1, nan, 2): not finite");
  mesh = tetrahedron_mesh();
  mesh.vertices[3][2] = -std::numeric_limits<double>::infinity();
  CHECK(reason(mesh) == "vertex 4 is at (0, 0, -inf): not finite");
}

TEST_CASE("a mesh needs a mass") {
  CHECK(mesh_body("body", *mesh_mass(tetrahedron_mesh()), 0).error().reason ==
        "the mesh has the mass 0 kg, which must be finite and positive");
}

}  // namespace
}  // namespace rigor
