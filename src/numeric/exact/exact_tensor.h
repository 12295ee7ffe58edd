// SPDX-License-Identifier: GPL-3.0-or-later
// Inertia tensors about the centre of mass without any rounding, for the doubles as they are given.
#pragma once

#include <optional>
#include <span>

#include "numeric/exact/long_sum.h"
#include "numeric/kernels/mass_sums.h"
#include "numeric/kernels/triangles.h"

namespace rigor {

/// entries 2^exponent / divisor; symmetric, the divisor positive.
struct ExactTensor {
  std::array<std::array<Integer, 3>, 3> entries;
  Integer divisor = 1;
  int exponent = 0;
};

/// Inertia about the centre of mass, and mass 2^mass_exponent.
struct ExactBody {
  ExactTensor inertia;
  Integer mass;
  int mass_exponent = 0;
};

/// Of points that `check_points` accepts: with M = Σm, S = Σ m x and Q = Σ m x x, J = (M Q − S S)/M, I =
/// tr(J) 1 − J. Cost: 0.1 us a point.
[[nodiscard]] ExactBody exact_body(const PointColumns& points);
[[nodiscard]] ExactBody exact_body(const ExactTensor& inertia, double mass);

/// Bodies with their centres of mass at places: I = Σ I_p + that of their masses at the places.
struct PlacedExactBody {
  const ExactBody* body = nullptr;
  Position at{};
};
[[nodiscard]] ExactBody exact_joined(std::span<const PlacedExactBody> parts);

/// With axis i where i + step was, cyclically.
[[nodiscard]] ExactBody along_axis(const ExactBody& body, std::size_t step);

/// A homogeneous solid: volume 2^exponent / 6, and ∫x_i x_j dV / V about its centre, which is at
/// 2^centre_exponent centre / volume.
struct ExactSolid {
  Integer volume;
  int exponent = 0;
  ExactTensor second_moments;
  std::array<Integer, 3> centre;
  int centre_exponent = 0;
  bool is_turned = false;  // the triangles are clockwise
};

/// above 2^exponent / below, rounded to 2^-104 of itself.
[[nodiscard]] HighLow rounded_quotient(const Integer& above, const Integer& below, int exponent);

/// Of what a closed surface encloses: with D = det(a, b, c) for each triangle and s = a + b + c, A = ΣD, F =
/// ΣD s and G = ΣD (a a + b b + c c + s s), V = |A|/6 and ∫x x dV/V = (4 A G − 5 F F)/(80 A²). Cost: some 5
/// us a triangle. Nothing for more than 100,000 triangles, for coordinates that together have more than 400
/// bits, and where A is 0.
[[nodiscard]] std::optional<ExactSolid> exact_solid(const Mesh& mesh);

/// The entries as doubles.
[[nodiscard]] ExactTensor exact_tensor(const InertiaTensor& tensor);

[[nodiscard]] ExactTensor times(ExactTensor tensor, double factor);
/// In a unit of length that is `unit` of the solid's.
[[nodiscard]] ExactSolid times_unit(ExactSolid solid, double unit);
/// Of a solid of that mass, and of that density.
[[nodiscard]] ExactTensor inertia_with_mass(const ExactSolid& solid, double mass);
[[nodiscard]] ExactTensor inertia_with_density(const ExactSolid& solid, double density);

}  // namespace rigor
