// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_peers.h"

namespace rigor {
namespace {

/// The integrals of one coordinate over a triangle, in Eberly's names.
struct Subexpressions {
  double f1, f2, f3;
  double g0, g1, g2;
};

Subexpressions subexpressions(double w0, double w1, double w2) {
  Subexpressions s{};
  const double t0 = w0 + w1;
  s.f1 = t0 + w2;
  const double t1 = w0 * w0;
  const double t2 = t1 + w1 * t0;
  s.f2 = t2 + w2 * s.f1;
  s.f3 = w0 * t1 + w1 * t2 + w2 * s.f2;
  s.g0 = s.f2 + w0 * (s.f1 + w0);
  s.g1 = s.f2 + w1 * (s.f1 + w1);
  s.g2 = s.f2 + w2 * (s.f1 + w2);
  return s;
}

}  // namespace

PlainMeshSums eberly_mesh_sums(const Mesh& mesh) {
  double volume = 0;
  Position first{};
  Position square{};
  Position product{};  // of x_i x_j for j = i + 1
  for (const auto& triangle : mesh.triangles) {
    const Position& a = mesh.vertices[triangle[0]];
    const Position& b = mesh.vertices[triangle[1]];
    const Position& c = mesh.vertices[triangle[2]];
    Position d{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      d[i] = (b[j] - a[j]) * (c[k] - a[k]) - (c[j] - a[j]) * (b[k] - a[k]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const Subexpressions s = subexpressions(a[i], b[i], c[i]);
      if (i == 0) volume += d[0] * s.f1;
      first[i] += d[i] * s.f2;
      square[i] += d[i] * s.f3;
      product[i] += d[i] * (a[j] * s.g0 + b[j] * s.g1 + c[j] * s.g2);
    }
  }
  PlainMeshSums sums;
  sums.volume = volume / 6;
  for (std::size_t i = 0; i < 3; ++i) sums.centre[i] = first[i] / 24 / sums.volume;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    sums.second[i][i] = square[i] / 60 / sums.volume - sums.centre[i] * sums.centre[i];
    sums.second[i][j] = sums.second[j][i] = product[i] / 120 / sums.volume - sums.centre[i] * sums.centre[j];
  }
  return sums;
}

PlainMeshSums mean_mesh_sums(const Mesh& mesh) { return plain_mesh_sums(mesh, vertex_mean(mesh)); }

PlainMeshSums origin_mesh_sums(const Mesh& mesh) {
  double six_volumes = 0;
  Position first{};
  std::array<double, 6> second{};
  for (const auto& triangle : mesh.triangles) {
    const Position& a = mesh.vertices[triangle[0]];
    const Position& b = mesh.vertices[triangle[1]];
    const Position& c = mesh.vertices[triangle[2]];
    const double d = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                     a[2] * (b[0] * c[1] - b[1] * c[0]);
    six_volumes += d;
    Position s{};
    std::size_t ij = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      s[i] = a[i] + b[i] + c[i];
      first[i] += d * s[i];
      for (std::size_t j = 0; j <= i; ++j)
        second[ij++] += d * (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + s[i] * s[j]);
    }
  }
  PlainMeshSums sums;
  sums.volume = six_volumes / 6;
  std::size_t ij = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    sums.centre[i] = first[i] / (4 * six_volumes);
    for (std::size_t j = 0; j <= i; ++j)
      sums.second[i][j] = sums.second[j][i] =
          second[ij++] / (20 * six_volumes) - sums.centre[i] * sums.centre[j];
  }
  return sums;
}

}  // namespace rigor
