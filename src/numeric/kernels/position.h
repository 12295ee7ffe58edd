// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors and symmetric tensors by their components, as bodies and kernels hand them on.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace rigor {

/// A point or a vector by its components along the body's axes.
using Position = std::array<double, 3>;
/// I_ij = Σ m (r² δ_ij − x_i x_j), row by row; products of inertia carry the minus.
using InertiaTensor = std::array<Position, 3>;

[[nodiscard]] inline bool are_finite(std::span<const double> numbers) {
  return std::ranges::all_of(numbers, [](double each) { return std::isfinite(each); });
}

}  // namespace rigor
