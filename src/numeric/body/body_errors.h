// SPDX-License-Identifier: GPL-3.0-or-later
// Bounds of what a body lost when its particles were made, for whoever bounds the error of what is computed
// of them.
#pragma once

#include <vector>

#include "numeric/body/bodies.h"
#include "numeric/program/samples.h"

namespace rigor {

/// m, of the coordinates along an axis: see `BodyErrors`.
[[nodiscard]] ErrorBounds place_errors(const Body& body, std::size_t axis);
/// The same along any axis to which particles are turned, which is off by `turning` at most, as a vector.
/// Refers to the body's places, which may be turned.
[[nodiscard]] ErrorBounds turned_place_errors(const Body& body, double turning);

/// How far any entry of the inertia tensor of the particles, about their centre of mass, may be from that of
/// the described body, kg m². Error: rounded upwards. Cost: O(N).
[[nodiscard]] double inertia_error(const Body& body);

/// m, of each coordinate of the six particles ±r_k that `equimomental_body` makes, in their order.
///
/// With P = (r_1, r_2, r_3)/√3, what is described is S = P Pᵀ − E, E the residual, computed in double-double,
/// and the error of the second moments as given. Six particles of exactly that S are at the columns of ±√3 L
/// for its Cholesky factor L from the longest axis to the shortest; with E along the axes n_k, to first order
/// and with a margin of 2, L is off from P by E_kk/(2 √λ_k) in its column k along n_k and by E_ak/√λ_k along
/// the shorter n_a; for λ_k < 4 E_kk by no more than √(λ_a + E_aa).
[[nodiscard]] std::array<std::vector<double>, 3> equimomental_errors(const Body& body,
                                                                     const std::array<Position, 3>& axes,
                                                                     const SecondMoments& second);

}  // namespace rigor
