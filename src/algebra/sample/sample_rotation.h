// SPDX-License-Identifier: GPL-3.0-or-later
// Rotations with rational components, for samples. Row by row: the first axis is the rotated one.
#pragma once

#include <array>
#include <span>

#include "algebra/engine/exact_number.h"
#include "base/splitmix.h"

namespace rigor {

using RotationMatrix = std::array<Rational, 9>;

/// Those that a reader knows, the simplest first: the identity, quarter and half turns about the axes, the
/// cyclic permutations of the axes.
[[nodiscard]] std::span<const RotationMatrix> known_rotations();

/// The rotation by the quaternion w + x i + y j + z k, which is not 0 and need not have length 1 (Rodrigues):
/// every rational rotation is that of four integers.
[[nodiscard]] RotationMatrix rotation_of_quaternion(const std::array<int, 4>& quaternion);

/// Known ones (the identity seldom), or those of small quaternions too.
[[nodiscard]] RotationMatrix draw_rotation(bool known, SplitMix& random);

/// Are the rows an orthonormal, right-handed set?
[[nodiscard]] bool is_rotation(std::span<const Rational> components);

/// 0 the identity, 1 a quarter or half turn about an axis, 2 another that permutes the axes, 3 any other.
[[nodiscard]] std::uint32_t strangeness(std::span<const Rational> rotation);

}  // namespace rigor
