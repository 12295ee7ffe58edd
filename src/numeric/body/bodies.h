// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies made of bodies, and bodies given by their moments only.
#pragma once

#include <string>
#include <vector>

#include "numeric/body/body.h"

namespace rigor {

/// A body whose z axis becomes the axis `axis` (0 to 2), by a cyclic exchange of the axes; exact.
[[nodiscard]] Body along_axis(Body body, std::size_t axis);

struct PlacedBody {
  Body body;
  Position offset{};  // where its centre of mass is
};

/// All particles of all parts, about the common centre of mass. Where the inertia of every part is known, so
/// is the whole's, by the parallel-axis theorem in double-double: I = Σ I_p + m_p (d² 1 − d d). No digit is
/// lost where the parts are far from the origin. Of parts that are moved in, one number of a particle is held
/// twice at most.
[[nodiscard]] Result<Body> joined(std::string name, std::vector<PlacedBody> parts);

/// ∫x_i x_j dm/M about the centre of mass, m², and a bound of the error of any of them.
struct SecondMoments {
  SharpTensor moments{};
  double error = 0;
};

/// Six particles of M/6 at ±√(3 λ_k) along the principal axes of the second moments, λ_k their eigenvalues:
/// the same mass, centre and inertia tensor. The errors of the body are those of its places from the places
/// of six such particles of exactly these second moments; `mass_error`: relative to the mass.
[[nodiscard]] Result<Body> equimomental_body(std::string name, double mass, const SecondMoments& second,
                                             double mass_error = 0);
[[nodiscard]] Result<Body> equimomental_body(std::string name, double mass,
                                             const InertiaTensor& second_moments);

/// The same for an inertia tensor about the centre of mass, kg m², which `check_inertia` accepts.
[[nodiscard]] Result<Body> body_with_inertia(std::string name, double mass, const InertiaTensor& inertia);

}  // namespace rigor
