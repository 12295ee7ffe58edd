// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/family/family_values.h"

#include <cmath>

namespace rigor {
namespace {

double dot(const Position& a, const Position& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// M(q), with MᵀM = |q|⁴ 1: M_ii = q0² + q_i² − q_j² − q_k², M_ij = 2 (q_i q_j − q0 q_k), M_ji with a plus.
InertiaTensor unnormalised_rotation(const FourNumbers& q) {
  InertiaTensor m{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    m[i][i] = q[0] * q[0] + q[1 + i] * q[1 + i] - q[1 + j] * q[1 + j] - q[1 + k] * q[1 + k];
    m[i][j] = 2 * (q[1 + i] * q[1 + j] - q[0] * q[1 + k]);
    m[j][i] = 2 * (q[1 + i] * q[1 + j] + q[0] * q[1 + k]);
  }
  return m;
}

double square_of(const FourNumbers& q) { return q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]; }

}  // namespace

double draw_positive(SplitMix& bits) {
  const int exponent = static_cast<int>(bits.below(6)) - 3;
  return std::ldexp(1 + uniform(bits), exponent);
}

double draw_integer(SplitMix& bits) { return static_cast<double>(bits.below(19)) - 9; }

Position draw_direction(SplitMix& bits) {
  for (;;) {
    Position point{};
    for (double& x : point) x = uniform_sign(bits);
    const double square = dot(point, point);
    if (square <= 1 && square > 0x1p-20) return normalised(point);
  }
}

FourNumbers draw_quaternion(SplitMix& bits) {
  for (;;) {
    FourNumbers q{};
    for (double& x : q) x = uniform_sign(bits);
    if (square_of(q) <= 1 && square_of(q) >= 0.1) return q;
  }
}

FourNumbers draw_integer_quaternion(SplitMix& bits) {
  for (;;) {
    FourNumbers q{};
    for (double& x : q) x = static_cast<double>(bits.below(9)) - 4;
    if (square_of(q) > 0) return q;
  }
}

InertiaTensor rotation_of(const FourNumbers& q) {
  InertiaTensor m = unnormalised_rotation(q);
  for (Position& row : m) {
    for (double& x : row) x /= square_of(q);
  }
  return m;
}

InertiaTensor integer_axes(SplitMix& bits) { return unnormalised_rotation(draw_integer_quaternion(bits)); }

InertiaTensor inertia_of_rows(const InertiaTensor& rows) {
  const double trace = dot(rows[0], rows[0]) + dot(rows[1], rows[1]) + dot(rows[2], rows[2]);
  InertiaTensor inertia{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) inertia[i][j] = (i == j ? trace + 0.125 : 0) - dot(rows[i], rows[j]);
  }
  return inertia;
}

InertiaTensor with_eigenvalues(const Position& eigenvalues, const InertiaTensor& rows) {
  InertiaTensor tensor{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      for (std::size_t k = 0; k < 3; ++k) tensor[i][j] += eigenvalues[k] * (rows[k][i] * rows[k][j]);
      tensor[j][i] = tensor[i][j];
    }
  }
  return tensor;
}

Position normalised(const Position& vector) { return scaled(vector, 1 / std::sqrt(dot(vector, vector))); }

Position scaled(const Position& vector, double factor) {
  return {vector[0] * factor, vector[1] * factor, vector[2] * factor};
}

Position sum(const Position& a, const Position& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

Position perpendicular(const Position& axis, const Position& other) {
  const double along = dot(axis, other);
  const Position rest = sum(other, scaled(axis, -along));
  if (dot(rest, rest) > 0x1p-20) return normalised(rest);
  Position third{};
  std::size_t least = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    if (std::abs(axis[i]) < std::abs(axis[least])) least = i;
  }
  third[least] = 1;
  return perpendicular(axis, third);
}

}  // namespace rigor
