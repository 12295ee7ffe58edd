// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/sample/sample_rotation.h"

#include <algorithm>
#include <vector>

namespace rigor {
namespace {

constexpr int largest_number = 2;  // of a quaternion that is drawn

[[nodiscard]] std::vector<RotationMatrix> make_known() {
  std::vector<std::array<int, 4>> quaternions{{1, 0, 0, 0}};
  for (const int w : {1, 0}) {  // a quarter turn, a half turn
    for (const std::size_t axis : {3u, 1u, 2u}) {
      std::array<int, 4> quaternion{w, 0, 0, 0};
      quaternion[axis] = 1;
      quaternions.push_back(quaternion);
    }
  }
  for (const int axis : {3, 1, 2}) {
    std::array<int, 4> quaternion{1, 0, 0, 0};
    quaternion[static_cast<std::size_t>(axis)] = -1;
    quaternions.push_back(quaternion);
  }
  quaternions.push_back({1, 1, 1, 1});
  quaternions.push_back({-1, 1, 1, 1});
  std::vector<RotationMatrix> known;
  for (const auto& quaternion : quaternions) known.push_back(rotation_of_quaternion(quaternion));
  return known;
}

[[nodiscard]] Rational dot_of_rows(std::span<const Rational> matrix, std::size_t a, std::size_t b) {
  Rational total = 0;
  for (std::size_t k = 0; k < 3; ++k) total = total + matrix[3 * a + k] * matrix[3 * b + k];
  return total;
}

}  // namespace

std::span<const RotationMatrix> known_rotations() {
  static const std::vector<RotationMatrix> known = make_known();
  return known;
}

/// R_ij = ((w² − v·v) δ_ij + 2 v_i v_j − 2 w ε_ijk v_k) / (w² + v·v)
RotationMatrix rotation_of_quaternion(const std::array<int, 4>& quaternion) {
  const int w = quaternion[0];
  const std::array v{quaternion[1], quaternion[2], quaternion[3]};
  const int square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  RotationMatrix rotation;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const Rational length = w * w + square;
    rotation[3 * i + i] = (w * w - square + 2 * v[i] * v[i]) / length;
    rotation[3 * i + j] = (2 * v[i] * v[j] - 2 * w * v[k]) / length;
    rotation[3 * j + i] = (2 * v[i] * v[j] + 2 * w * v[k]) / length;
  }
  return rotation;
}

RotationMatrix draw_rotation(bool known, SplitMix& random) {
  const auto choices = known_rotations();
  if (known || random.below(4) == 0) {
    const std::size_t choice = random.below(2 * choices.size());
    return choices[choice == 0 ? 0 : 1 + choice % (choices.size() - 1)];
  }
  std::array<int, 4> quaternion{};
  for (int& each : quaternion) each = static_cast<int>(random.below(2 * largest_number + 1)) - largest_number;
  if (quaternion == std::array<int, 4>{}) quaternion[0] = quaternion[3] = 1;
  return rotation_of_quaternion(quaternion);
}

bool is_rotation(std::span<const Rational> components) {
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = a; b < 3; ++b) {
      if (dot_of_rows(components, a, b) != (a == b ? 1 : 0)) return false;
    }
  }
  Rational determinant = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    determinant = determinant + components[i] * (components[3 + j] * components[6 + k] -
                                                 components[3 + k] * components[6 + j]);
  }
  return determinant == 1;
}

std::uint32_t strangeness(std::span<const Rational> rotation) {
  const bool permutes =
      std::ranges::all_of(rotation, [](const Rational& each) { return each == 0 || cln::abs(each) == 1; });
  if (!permutes) return 3;
  const int fixed = (rotation[0] == 1 ? 1 : 0) + (rotation[4] == 1 ? 1 : 0) + (rotation[8] == 1 ? 1 : 0);
  return fixed == 3 ? 0 : fixed == 1 ? 1 : 2;
}

}  // namespace rigor
