// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/kernels/mesh_families.h"

#include <cmath>
#include <functional>
#include <numbers>

#include "numeric/meshes.h"
#include "numeric/program/uniform.h"

namespace rigor {
namespace {

Mesh moved(Mesh mesh, const std::function<Position(const Position&)>& map) {
  for (Position& vertex : mesh.vertices) vertex = map(vertex);
  return mesh;
}

Mesh scaled(const Mesh& mesh, const Position& factors) {
  return moved(mesh, [&](const Position& r) {
    return Position{r[0] * factors[0], r[1] * factors[1], r[2] * factors[2]};
  });
}

/// By the rotation of a quaternion, rounded.
Mesh turned(const Mesh& mesh, SplitMix& bits) {
  const double w = uniform_sign(bits);
  const Position v{uniform_sign(bits), uniform_sign(bits), uniform_sign(bits)};
  const double square = w * w + v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  return moved(mesh, [&](const Position& r) {
    Position result{};
    const double along = v[0] * r[0] + v[1] * r[1] + v[2] * r[2];
    const double rest = w * w - (square - w * w);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      result[i] = (rest * r[i] + 2 * along * v[i] + 2 * w * (v[j] * r[k] - v[k] * r[j])) / square;
    }
    return result;
  });
}

/// Of two circles of radii 1 and 0.4; at least `triangles`.
Mesh torus(std::size_t triangles) {
  Mesh mesh;
  auto count = static_cast<std::uint32_t>(std::ceil(std::sqrt(static_cast<double>(triangles) / 2)));
  count = std::max(count, 4U);
  const auto angle = [&](std::uint32_t n) { return 2 * std::numbers::pi * n / count; };
  for (std::uint32_t m = 0; m < count; ++m) {
    for (std::uint32_t n = 0; n < count; ++n) {
      const double radius = 1 + 0.4 * std::cos(angle(n));
      mesh.vertices.push_back(
          {radius * std::cos(angle(m)), radius * std::sin(angle(m)), 0.4 * std::sin(angle(n))});
      const std::uint32_t m1 = (m + 1) % count;
      const std::uint32_t n1 = (n + 1) % count;
      mesh.triangles.push_back({m * count + n, m1 * count + n, m1 * count + n1});
      mesh.triangles.push_back({m * count + n, m1 * count + n1, m * count + n1});
    }
  }
  return mesh;
}

/// Between spheres of radii 1 and 1 − thickness.
Mesh hollow(std::size_t triangles, double thickness) {
  Mesh mesh = fine_sphere(triangles / 2);
  const auto offset = static_cast<std::uint32_t>(mesh.vertices.size());
  const std::size_t outer = mesh.triangles.size();
  for (std::size_t n = 0; n < offset; ++n) {
    Position inner = mesh.vertices[n];
    for (double& x : inner) x *= 1 - thickness;
    mesh.vertices.push_back(inner);
  }
  for (std::size_t n = 0; n < outer; ++n) {
    const auto [a, b, c] = mesh.triangles[n];
    mesh.triangles.push_back({a + offset, c + offset, b + offset});
  }
  return mesh;
}

Mesh in_32_bits(const Mesh& mesh) {
  return moved(mesh, [](const Position& r) {
    Position result{};
    for (std::size_t i = 0; i < 3; ++i) result[i] = static_cast<float>(r[i]);
    return result;
  });
}

}  // namespace

Mesh fine_sphere(std::size_t triangles) {
  int times = 0;
  while ((std::size_t{8} << (2 * times)) < triangles) ++times;
  return sphere_mesh(times);
}

std::vector<MeshFamily> mesh_families(std::size_t triangles) {
  SplitMix bits(1);
  std::vector<MeshFamily> families;
  const Mesh sphere = fine_sphere(triangles);
  for (const char* distance : {"0", "1", "1e4", "1e8", "1e12"}) {
    const double d = std::stod(distance);
    families.push_back(
        {std::string("distance ") + distance, {shifted(sphere, d), shifted(torus(triangles), d)}});
  }
  families[1].meshes.push_back(scaled(families[1].meshes[0], {0.7, 0.7, 0.7}));  // no short differences
  families.push_back({"boxes, tetrahedra", {}});
  for (int n = 0; n < 16; ++n) {
    const Position corner{uniform_sign(bits), 10 * uniform_sign(bits), 100 * uniform_sign(bits)};
    families.back().meshes.push_back(box_mesh({1 + uniform(bits), 1 + uniform(bits), uniform(bits)}, corner));
    families.back().meshes.push_back(turned(scaled(tetrahedron_mesh(), {1, uniform(bits), 3}), bits));
  }
  for (const char* thickness : {"1e-2", "1e-4", "1e-6", "1e-8"}) {
    const double t = std::stod(thickness);
    families.push_back({std::string("thickness ") + thickness, {hollow(triangles, t)}});
    for (const double distance : {0., 1., 1e2, 1e8}) {
      // at 1e8 the doubles are 1.5e-8 apart
      const double least = std::max(t, distance * 1e-9);
      families.back().meshes.push_back(shifted(turned(scaled(sphere, {1, 1, least}), bits), distance));
      families.back().meshes.push_back(shifted(turned(scaled(sphere, {1, least, least}), bits), distance));
      families.back().meshes.push_back(
          shifted(turned(box_mesh({1, 1, 10 * least}, {0, 0, 0}), bits), distance));
    }
  }
  families.push_back({"32-bit", {in_32_bits(shifted(sphere, 1e4)), in_32_bits(torus(triangles))}});
  families.push_back({"scale 1e100, 1e-100",
                      {scaled(sphere, {1e100, 1e100, 1e100}), scaled(sphere, {1e-100, 1e-100, 1e-100}),
                       scaled(sphere, {1e150, 1e-150, 1})}});
  return families;
}

void MeshError::widen(const MeshError& other) {
  volume = std::max(volume, other.volume);
  centre = std::max(centre, other.centre);
  entry = std::max(entry, other.entry);
  tensor = std::max(tensor, other.tensor);
}

Position vertex_mean(const Mesh& mesh) {
  Position mean{};
  for (const Position& vertex : mesh.vertices)
    for (std::size_t i = 0; i < 3; ++i) mean[i] += vertex[i] / static_cast<double>(mesh.vertices.size());
  return mean;
}

PlainMeshSums plain_mesh_sums(const Mesh& mesh, const Position& about) {
  double six_volumes = 0;
  Position first{};
  InertiaTensor second{};
  for (const auto& triangle : mesh.triangles) {
    Position a = mesh.vertices[triangle[0]];
    Position b = mesh.vertices[triangle[1]];
    Position c = mesh.vertices[triangle[2]];
    Position s{};
    for (std::size_t i = 0; i < 3; ++i) {
      a[i] -= about[i];
      b[i] -= about[i];
      c[i] -= about[i];
      s[i] = a[i] + b[i] + c[i];
    }
    double determinant = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      determinant += a[i] * (b[j] * c[k] - b[k] * c[j]);
    }
    six_volumes += determinant;
    for (std::size_t i = 0; i < 3; ++i) {
      first[i] += determinant * s[i];
      for (std::size_t j = 0; j <= i; ++j)
        second[i][j] += determinant * (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + s[i] * s[j]);
    }
  }
  PlainMeshSums sums;
  sums.volume = six_volumes / 6;
  for (std::size_t i = 0; i < 3; ++i) {
    const double from = first[i] / (4 * six_volumes);
    sums.centre[i] = about[i] + from;
    for (std::size_t j = 0; j <= i; ++j)
      sums.second[i][j] = sums.second[j][i] =
          second[i][j] / (20 * six_volumes) - from * (first[j] / (4 * six_volumes));
  }
  return sums;
}

}  // namespace rigor
