// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/kernels/mesh_sums.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "catch.h"
#include "numeric/kernels/mesh_families.h"
#include "numeric/meshes.h"
#include "numeric/program/uniform.h"

namespace rigor {
namespace {

MeshError error_of(const MeshReference& exact, const MeshMoments& moments, bool with_low) {
  const auto value = [&](const HighLow& x) { return Digits100(x.high) + (with_low ? x.low : 0); };
  std::array<Digits100, 3> centre;
  std::array<std::array<Digits100, 3>, 3> second;
  for (std::size_t i = 0; i < 3; ++i) {
    centre[i] = value(moments.centre[i]);
    for (std::size_t j = 0; j < 3; ++j) second[i][j] = value(moments.second_moments[i][j]);
  }
  return mesh_error(exact, value(moments.volume), centre, second);
}

std::string refusal(const Mesh& mesh) {
  const auto moments = mesh_moments(mesh.vertices, mesh.triangles);
  return moments ? "accepted" : moments.error().reason;
}

Result<MeshMoments> moments_of(const Mesh& mesh, MeshSharpness sharpness = MeshSharpness::if_needed) {
  return mesh_moments(mesh.vertices, mesh.triangles, sharpness);
}

/// Of the box of a mesh, over the volume inside.
double emptiness(const Mesh& mesh, const MeshReference& exact) {
  Digits100 box = 1;
  for (std::size_t i = 0; i < 3; ++i) {
    double least = mesh.vertices.front()[i];
    double most = least;
    for (const Position& vertex : mesh.vertices) {
      least = std::min(least, vertex[i]);
      most = std::max(most, vertex[i]);
    }
    box *= Digits100(most) - least;
  }
  return static_cast<double>(Digits100(box / abs(exact.volume)));
}

TEST_CASE(
    "meshes at any distance and as thin as may be keep all digits of volume, centre and second moments") {
  for (const MeshFamily& family : mesh_families(512)) {
    INFO(family.name);
    for (const Mesh& mesh : family.meshes) {
      const auto moments = moments_of(mesh);
      REQUIRE(moments);
      const MeshError error = error_of(mesh_reference(mesh), *moments, false);
      CHECK(error.volume <= 1);
      CHECK(error.centre <= 2);
      CHECK(error.entry <= 2);
      CHECK(error.tensor <= 2);
    }
  }
}

TEST_CASE(
    "moments of meshes in two parts have thirty digits, less those of the box's volume over the body's") {
  for (const MeshFamily& family : mesh_families(512)) {
    if (family.name.starts_with("scale")) continue;  // low parts below the normal range
    INFO(family.name);
    for (const Mesh& mesh : family.meshes) {
      const auto moments = moments_of(mesh, MeshSharpness::always);
      REQUIRE(moments);
      CHECK(moments->sharp);
      const MeshReference exact = mesh_reference(mesh);
      const MeshError error = error_of(exact, *moments, true);
      const double bound = 0x1p-44 * emptiness(mesh, exact);  // in units of 2^-53
      CHECK(error.volume <= bound);
      CHECK(error.centre <= bound);
      CHECK(error.entry <= 4 * bound);
    }
  }
}

/// The greatest error of volume, centre and second moments, over the bound that comes with it.
double part_of_errors(const Mesh& mesh, const MeshMoments& moments) {
  const MeshReference exact = mesh_reference(mesh);
  double worst = 0;
  const auto widen = [&](const HighLow& found, const Digits100& of, const Digits100& bound) {
    worst =
        std::max(worst, static_cast<double>(Digits100(abs(Digits100(found.high) + found.low - of) / bound)));
  };
  widen(moments.volume, exact.volume, moments.errors.volume * abs(exact.volume));
  for (std::size_t i = 0; i < 3; ++i) {
    widen(moments.centre[i], exact.centre[i], moments.errors.centre[i]);
    for (std::size_t j = 0; j < 3; ++j)
      widen(moments.second_moments[i][j], exact.second[i][j], moments.errors.second_moments[i][j]);
  }
  return worst;
}

TEST_CASE("the errors of sharp moments are below their bounds, in needles of many triangles, too") {
  double worst = 0;
  for (const std::size_t triangles : {8U, 512U, 20000U}) {
    for (const MeshFamily& family : mesh_families(triangles)) {
      const bool thin = family.name.starts_with("thickness");
      if (family.name.starts_with("scale") || (triangles == 20000U && family.name != "thickness 1e-8"))
        continue;
      INFO(family.name << ", " << triangles);
      for (const Mesh& mesh : family.meshes) {
        const auto moments = moments_of(mesh, MeshSharpness::always);
        REQUIRE(moments);
        const double part = part_of_errors(mesh, *moments);
        CHECK(part <= 1);
        if (thin) worst = std::max(worst, part);
      }
    }
  }
  CHECK(worst > 0x1p-10);  // so that the bounds say something
}

TEST_CASE(
    "the plain sum over tetrahedra misses these bounds, far away about the origin and thin about the mean") {
  for (const MeshFamily& family : mesh_families(512)) {
    INFO(family.name);
    MeshError origin;
    MeshError mean;
    for (const Mesh& mesh : family.meshes) {
      const MeshReference exact = mesh_reference(mesh);
      origin.widen(plain_error(exact, plain_mesh_sums(mesh)));
      mean.widen(plain_error(exact, plain_mesh_sums(mesh, vertex_mean(mesh))));
    }
    if (family.name == "distance 1e4") CHECK(origin.tensor > 1e9);
    if (family.name == "distance 1e8") CHECK(!(origin.tensor < 0x1p53));
    if (family.name == "thickness 1e-4") CHECK(mean.tensor > 1e3);
    if (family.name == "thickness 1e-8") CHECK(mean.tensor > 1e6);
    if (family.name == "boxes, tetrahedra") CHECK(mean.entry > 2);
  }
}

TEST_CASE("moments of meshes have the same bits with every instruction set") {
  for (const std::size_t triangles : {8U, 2048U}) {
    for (const MeshFamily& family : mesh_families(triangles)) {
      INFO(family.name);
      for (const Mesh& mesh : family.meshes) {
        for (const MeshSharpness sharpness : {MeshSharpness::if_needed, MeshSharpness::always}) {
          const auto expected = moments_of(mesh, sharpness);
          REQUIRE(expected);
          for (const LaneKernels* kernels : runnable_lane_kernels()) {
            INFO(kernels->instruction_set);
            const auto moments = mesh_moments(mesh.vertices, mesh.triangles, sharpness, *kernels);
            REQUIRE(moments);
            CHECK(std::memcmp(&*moments, &*expected, offsetof(MeshMoments, sharp)) == 0);
            CHECK(moments->sharp == expected->sharp);
            CHECK(moments->flat == expected->flat);
          }
        }
      }
    }
  }
}

/// About the origin, with axes from 1e-7 to 1e-2.
Mesh small_ellipsoid(SplitMix& bits) {
  Mesh mesh = fine_sphere(512);
  Position axes{};
  for (double& axis : axes) axis = std::pow(10, -2 - 5 * uniform(bits));
  for (Position& vertex : mesh.vertices)
    for (std::size_t i = 0; i < 3; ++i) vertex[i] *= axes[i];
  return mesh;
}

TEST_CASE("second moments of small crooked ellipsoids and of slivers far away are right to 3 u") {
  SplitMix bits(1);
  double worst = 0;
  const auto check = [&](const Mesh& mesh) {
    const auto moments = moments_of(mesh);
    REQUIRE(moments);
    const MeshError error = error_of(mesh_reference(mesh), *moments, false);
    CHECK(error.entry <= 3);
    worst = std::max(worst, error.entry);
  };
  for (int n = 0; n < 100; ++n) check(small_ellipsoid(bits));
  CHECK(worst > 1);  // so that 3 says something
  for (int n = 0; n < 100; ++n) {
    const Mesh sliver =
        box_mesh({1e-8 * (1 + uniform(bits)), 1e3 * uniform(bits), 1e-3 + uniform(bits)},
                 {2e-8 * uniform_sign(bits), 3e9 * uniform_sign(bits), 3e9 * uniform_sign(bits)});
    check(sliver);
    Mesh two = sliver;  // 24 triangles
    for (const Position& vertex : sliver.vertices)
      two.vertices.push_back({vertex[0] + 4e-8, vertex[1], vertex[2]});
    for (const auto& [a, b, c] : sliver.triangles) two.triangles.push_back({a + 8, b + 8, c + 8});
    check(two);
  }
}

TEST_CASE("a box and a corner tetrahedron have their moments to the last bit or two") {
  const auto box = moments_of(box_mesh({1, 2, 4}, {1e8, -3, 0}));
  REQUIRE(box);
  CHECK(box->volume.high == 8);
  CHECK(box->centre[0].high == 1e8 + 0.5);
  CHECK(box->centre[1].high == -2);
  const Position sides{1, 2, 4};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      CHECK(box->second_moments[i][j].high == (i == j ? sides[i] * sides[i] / 12 : 0));
  const auto corner = moments_of(tetrahedron_mesh());
  REQUIRE(corner);
  CHECK(corner->volume.high == 1. / 6);
  CHECK(corner->second_moments[0][0].high == 3. / 80);
  CHECK(corner->second_moments[0][1].high == -1. / 80);
}

TEST_CASE("a fine torus comes near the torus, and a hollow sphere is the outer one less the inner one") {
  const std::vector<MeshFamily> families = mesh_families(20000);
  const auto torus = moments_of(families[0].meshes[1]);
  REQUIRE(torus);
  constexpr double r = 0.4;
  constexpr double pi = std::numbers::pi;
  CHECK(torus->volume.high == Approx(2 * pi * pi * r * r).epsilon(2e-3));
  CHECK(torus->second_moments[2][2].high == Approx(r * r / 4).epsilon(2e-3));
  CHECK(torus->second_moments[0][0].high == Approx(0.5 + 3 * r * r / 8).epsilon(2e-3));
  CHECK(std::abs(torus->centre[0].high) < 1e-15);
  const auto sphere = moments_of(families[0].meshes[0]);
  const auto& shells = families[6];
  REQUIRE(shells.name == "thickness 1e-2");
  const auto shell = moments_of(shells.meshes[0]);
  REQUIRE((sphere && shell));
  CHECK(shell->sharp);
  CHECK(shell->volume.high == Approx(4 * pi / 3 * (1 - 0.99 * 0.99 * 0.99)).epsilon(2e-3));
}

TEST_CASE("clockwise triangles have a negative volume and the same centre and second moments") {
  Mesh mesh = fine_sphere(512);
  const auto before = moments_of(mesh);
  for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  const auto after = moments_of(mesh);
  REQUIRE((before && after));
  CHECK(after->volume.high == Approx(-before->volume.high).epsilon(0x1p-51));
  CHECK(after->second_moments[2][2].high == Approx(before->second_moments[2][2].high).epsilon(0x1p-51));
}

TEST_CASE("what encloses no volume is told from what encloses little, by the doubles as they are") {
  Mesh mesh = box_mesh({1, 1, 0}, {0, 0, 3});
  CHECK(refusal(mesh) == "the mesh encloses no volume");
  mesh = tetrahedron_mesh();
  for (Position& vertex : mesh.vertices) vertex[2] = vertex[0] + vertex[1];
  CHECK(refusal(mesh) == "the mesh encloses no volume");
  mesh.vertices[3] = {0.25, 0.25, 0.5 + 0x1p-54};  // half a unit above the plane, which rounds away
  CHECK(refusal(mesh) == "the mesh encloses no volume");
  mesh.vertices[3] = {0.25, 0.25, 0.5 + 0x1p-53};
  const auto moments = moments_of(mesh);
  REQUIRE(moments);
  CHECK(moments->volume.high == 0x1p-53 / 6);
  CHECK(moments->flat > 0);
}

TEST_CASE("surfaces that enclose more inside out than the right way round are refused") {
  Mesh mesh = box_mesh({1, 1, 1}, {0, 0, 0});
  const Mesh other = box_mesh({1, 1, 0.75}, {9, 0, 0});
  for (const auto& [a, b, c] : other.triangles) mesh.triangles.push_back({a + 8, c + 8, b + 8});
  mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
  const std::string refused =
      "the second moments are not positive: the surface passes through itself, or one of several is turned "
      "inside out";
  CHECK(refusal(mesh) == refused);
  Mesh apart = fine_sphere(512);  // unit spheres, one inside out
  const auto count = static_cast<std::uint32_t>(apart.vertices.size());
  const Mesh turned = shifted(fine_sphere(128), 5);
  for (const auto& [a, b, c] : turned.triangles) apart.triangles.push_back({a + count, c + count, b + count});
  apart.vertices.insert(apart.vertices.end(), turned.vertices.begin(), turned.vertices.end());
  CHECK(refusal(apart) == refused);
}

TEST_CASE("a vertex that is no corner changes nothing, wherever it is") {
  for (const std::size_t triangles : {8U, 2048U}) {
    const Mesh sphere = fine_sphere(triangles);
    const auto without = moments_of(sphere);
    REQUIRE(without);
    for (const double far : {1e4, 1e8, 1e300}) {
      Mesh mesh = sphere;
      mesh.vertices.insert(mesh.vertices.begin() + 3, {far, -far, far});
      for (auto& triangle : mesh.triangles)
        for (std::uint32_t& corner : triangle) corner += corner < 3 ? 0 : 1;
      const auto with = moments_of(mesh);
      REQUIRE(with);
      CHECK(std::memcmp(&*with, &*without, offsetof(MeshMoments, sharp)) == 0);
      CHECK(with->sharp == without->sharp);
    }
  }
}

TEST_CASE("meshes of the greatest and least sizes are summed, or refused where a result is no double") {
  const auto scaled = [](double factor) {
    Mesh mesh = fine_sphere(512);
    for (Position& vertex : mesh.vertices)
      for (double& x : vertex) x *= factor;
    return mesh;
  };
  const auto one = moments_of(scaled(1));
  for (const double factor : {0x1p-330, 0x1p340}) {
    const auto moments = moments_of(scaled(factor));
    REQUIRE(moments);
    CHECK(moments->volume.high == one->volume.high * factor * factor * factor);
    CHECK(moments->second_moments[0][0].high == one->second_moments[0][0].high * factor * factor);
  }
  CHECK(refusal(scaled(0x1p1000)) == "the volume overflows");
  CHECK(refusal(scaled(0x1p-500)) == "the volume underflows");
  Mesh needle = box_mesh({0x1p900, 0x1p-400, 0x1p-400}, {0, 0, 0});
  CHECK(refusal(needle) == "the second moments overflow");
  needle = box_mesh({0x1p300, 0x1p-150, 0x1p-150}, {0, 0, 0});
  const auto thin = moments_of(needle);
  REQUIRE(thin);
  CHECK(thin->volume.high == 1);
  CHECK(thin->second_moments[1][1].high == 0x1p-300 / 12);
}

TEST_CASE("corners that are no vertices and coordinates that are no numbers are refused") {
  Mesh mesh = tetrahedron_mesh();
  mesh.triangles[2][1] = 4;
  CHECK(refusal(mesh) == "triangle 3 has the vertex 5 of 4");
  CHECK(refusal({}) == "the mesh has no triangles");
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    for (std::size_t n = 0; n < 12; ++n) {
      mesh = tetrahedron_mesh();
      mesh.vertices[n / 3][n % 3] = bad;
      CHECK(refusal(mesh) == "a coordinate of the mesh is not finite");
    }
  }
}

}  // namespace
}  // namespace rigor
