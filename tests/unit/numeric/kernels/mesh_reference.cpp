// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>

#include "numeric/kernels/mesh_families.h"

namespace rigor {
namespace {

using Integer = boost::multiprecision::cpp_int;
using Point = std::array<Integer, 3>;

/// The coordinates are these integers times 2^exponent.
struct IntegerVertices {
  std::vector<Point> at;
  int exponent = 0;
};

IntegerVertices in_integers(const Mesh& mesh) {
  IntegerVertices vertices;
  vertices.exponent = std::numeric_limits<int>::max();
  for (const Position& vertex : mesh.vertices)
    for (const double x : vertex)
      if (x != 0) vertices.exponent = std::min(vertices.exponent, std::ilogb(x) - 52);
  for (const Position& vertex : mesh.vertices) {
    vertices.at.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      int exponent = 0;
      const auto fraction = static_cast<std::int64_t>(std::ldexp(std::frexp(vertex[i], &exponent), 53));
      if (fraction != 0) vertices.at.back()[i] = Integer(fraction) << (exponent - 53 - vertices.exponent);
    }
  }
  return vertices;
}

/// 120 times the mean of x y z over a triangle, of three linear functions by their values at its corners,
/// twice: the integral of λ_i λ_j λ_k over a triangle is α!/5! of twice its area, α the powers of λ_1, λ_2,
/// λ_3.
Integer mean_of_cubes(const Point& x, const Point& y, const Point& z) {
  Integer sum = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t k = 0; k < 3; ++k) {
        const int alike = (i == j ? 1 : 0) + (j == k ? 1 : 0) + (k == i ? 1 : 0);
        sum += (alike == 3 ? 6 : alike == 1 ? 2 : 1) * x[i] * y[j] * z[k];
      }
  return sum;
}

struct IntegerSums {
  Integer volume;                                // 6 V
  Point first;                                   // 24 ∫x_i
  std::array<std::array<Integer, 3>, 3> second;  // 120 ∫x_i x_j for j ≤ i, by 3 for i = j
};

void add_face(IntegerSums& sums, const Point& a, const Point& b, const Point& c) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const Integer normal = (b[j] - a[j]) * (c[k] - a[k]) - (b[k] - a[k]) * (c[j] - a[j]);
    const Point x{a[i], b[i], c[i]};
    if (i == 0) sums.volume += normal * (x[0] + x[1] + x[2]);
    sums.first[i] +=
        normal * (x[0] * x[0] + x[1] * x[1] + x[2] * x[2] + x[0] * x[1] + x[1] * x[2] + x[2] * x[0]);
    for (std::size_t l = 0; l <= i; ++l)
      sums.second[i][l] += normal * mean_of_cubes(x, x, {a[l], b[l], c[l]});
  }
}

/// x 2^exponent
Digits100 times_power(const Digits100& x, int exponent) { return ldexp(x, exponent); }

}  // namespace

MeshReference mesh_reference(const Mesh& mesh) {
  const IntegerVertices vertices = in_integers(mesh);
  IntegerSums sums;
  for (const auto& [a, b, c] : mesh.triangles) add_face(sums, vertices.at[a], vertices.at[b], vertices.at[c]);
  MeshReference reference;
  const int e = vertices.exponent;
  reference.volume = times_power(Digits100(sums.volume) / 6, 3 * e);
  for (std::size_t i = 0; i < 3; ++i) {
    reference.centre[i] = times_power(Digits100(sums.first[i]) / Digits100(4 * sums.volume), e);
    for (std::size_t j = 0; j <= i; ++j) {
      // of ∫x_i x_j / V: 6/120 by ½, or by ⅓ for i = j; one fraction with the product of the centres
      const int parts = i == j ? 60 : 40;
      const Integer over = 16 * sums.second[i][j] * sums.volume - parts * sums.first[i] * sums.first[j];
      reference.second[i][j] =
          times_power(Digits100(over) / Digits100(16 * parts * sums.volume * sums.volume), 2 * e);
      reference.second[j][i] = reference.second[i][j];
    }
  }
  return reference;
}

MeshError mesh_error(const MeshReference& exact, const Digits100& volume,
                     const std::array<Digits100, 3>& centre,
                     const std::array<std::array<Digits100, 3>, 3>& second) {
  const auto units = [](const Digits100& error) { return static_cast<double>(ldexp(error, 53)); };
  MeshError error;
  error.volume = units(abs(volume / exact.volume - 1));
  Digits100 norm = 0;
  Digits100 all = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Digits100 size = sqrt(exact.second[i][i]);
    error.centre = std::max(error.centre, units(abs(centre[i] - exact.centre[i]) /
                                                std::max(size, Digits100(abs(exact.centre[i])))));
    for (std::size_t j = 0; j < 3; ++j) {
      const Digits100 wrong = abs(second[i][j] - exact.second[i][j]);
      error.entry = std::max(error.entry, units(wrong / (size * sqrt(exact.second[j][j]))));
      all += wrong * wrong;
      norm += exact.second[i][j] * exact.second[i][j];
    }
  }
  error.tensor = units(sqrt(all / norm));
  return error;
}

MeshError plain_error(const MeshReference& exact, const PlainMeshSums& sums) {
  std::array<Digits100, 3> centre;
  std::array<std::array<Digits100, 3>, 3> second;
  for (std::size_t i = 0; i < 3; ++i) {
    centre[i] = sums.centre[i];
    for (std::size_t j = 0; j < 3; ++j) second[i][j] = sums.second[i][j];
  }
  return mesh_error(exact, sums.volume, centre, second);
}

}  // namespace rigor
