// SPDX-License-Identifier: GPL-3.0-or-later
// Homogeneous shapes along their principal axes about their centre of mass, and particles that stand for
// them.
//
// Each is the image of one unit shape under x_k -> a_k x_k, with the half extents a_k, so that its second
// moments are ∫x_k² dm = M j_k a_k², and its moments of inertia I_i = M (j_k a_k² + j_l a_l²), (i, k, l)
// cyclic. Source of the j_k: L. D. Landau, E. M. Lifshitz, Mechanics, 3rd ed., §32, problem 2, and one
// integral each.
//
//   shape        extents                           j_1    j_2    j_3
//   rod          half the length along z            0      0     1/3
//   hoop         radii along x, y                  1/2    1/2     0     even over the eccentric angle
//   disc         radii along x, y                  1/4    1/4     0
//   plate        half the sides along x, y         1/3    1/3     0
//   box          half the sides                    1/3    1/3    1/3
//   sphere       radius                            1/5    1/5    1/5
//   shell        radius                            1/3    1/3    1/3
//   ellipsoid    radii                             1/5    1/5    1/5
//   cylinder     radii, half the height along z    1/4    1/4    1/3
//   cone         radii, the height along z         3/20   3/20   3/80   apex up, centre of mass at h/4
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "numeric/body/body.h"

namespace rigor {

enum class ShapeKind : std::uint8_t {
  rod,
  hoop,
  disc,
  plate,
  box,
  sphere,
  shell,
  ellipsoid,
  cylinder,
  cone,
};

struct ShapeInfo {
  ShapeKind kind;
  std::string_view name;       // `spherical shell`
  std::array<double, 3> over;  // j_k = over / under
  std::array<double, 3> under;
};

[[nodiscard]] std::span<const ShapeInfo> shape_table();
[[nodiscard]] const ShapeInfo& info(ShapeKind kind);

struct Shape {
  ShapeKind kind = ShapeKind::box;
  double mass = 0;     // kg
  Position extents{};  // m; 0 along an axis that the shape does not extend along
};

/// The mass and each extent must be positive and finite, and the moments may not overflow.
[[nodiscard]] Result<void> check_shape(const Shape& shape);

/// Error: 3u relative.
[[nodiscard]] Result<KnownInertia> inertia_of(const Shape& shape);

/// Equal masses at ±√j_k a_k along each axis that the shape extends along: 2, 4 or 8 particles, all inside it
/// or on it. Exact for all integrals of polynomials of degree 2 (3, but for the cone): the mass and the
/// centre of mass without an error, second moments to 4u, before the rounding of whoever adds them up.
[[nodiscard]] Result<Body> quadrature_body(std::string name, const Shape& shape);

/// Particles of equal mass, drawn uniformly from the shape, then about their centre of mass. The error of
/// ∫x_k x_l dm/M is below 5 e_k e_l / √N but for one body in two million, where |x_k| ≤ e_k in the shape.
[[nodiscard]] Result<Body> sampled_body(std::string name, const Shape& shape, std::size_t count,
                                        std::uint64_t seed);

}  // namespace rigor
