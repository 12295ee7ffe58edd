// SPDX-License-Identifier: GPL-3.0-or-later
// Single values that families of inputs are made of, drawn from random bits.
#pragma once

#include <array>

#include "base/splitmix.h"
#include "numeric/body/body.h"
#include "numeric/program/uniform.h"

namespace rigor {

/// From 1/8 to 8: one of six powers of two, times a number from 1 to 2.
[[nodiscard]] double draw_positive(SplitMix& bits);
/// −9 to 9.
[[nodiscard]] double draw_integer(SplitMix& bits);
/// Uniform on the unit sphere, of length 1 to 2u.
[[nodiscard]] Position draw_direction(SplitMix& bits);

using FourNumbers = std::array<double, 4>;  // a quaternion, its scalar part first
/// Uniform in direction; its square is from 0.1 to 1.
[[nodiscard]] FourNumbers draw_quaternion(SplitMix& bits);
/// Components from −4 to 4, not all 0.
[[nodiscard]] FourNumbers draw_integer_quaternion(SplitMix& bits);

/// The rows of the rotation M(q) / |q|²; orthogonal to 4u.
[[nodiscard]] InertiaTensor rotation_of(const FourNumbers& q);
/// The rows of M(q) for whole numbers: exactly at right angles, and whole.
[[nodiscard]] InertiaTensor integer_axes(SplitMix& bits);

/// tr(S) 1 − S + 1/8 with S = B Bᵀ: positive definite, and an inertia tensor. Whole where B is, but for 1/8.
[[nodiscard]] InertiaTensor inertia_of_rows(const InertiaTensor& rows);
/// Σ λ_k e_k e_k over the rows e_k; symmetric to the last bit.
[[nodiscard]] InertiaTensor with_eigenvalues(const Position& eigenvalues, const InertiaTensor& rows);

[[nodiscard]] Position normalised(const Position& vector);
[[nodiscard]] Position scaled(const Position& vector, double factor);
[[nodiscard]] Position sum(const Position& a, const Position& b);
/// A unit vector at right angles to a unit vector, in the plane of both (or any, where they are parallel).
[[nodiscard]] Position perpendicular(const Position& axis, const Position& other);

}  // namespace rigor
