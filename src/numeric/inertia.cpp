// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/inertia.h"

#include <cmath>
#include <utility>

namespace rigor {
namespace {

tl::unexpected<Error> refuse(std::string reason) { return tl::unexpected(Error{std::move(reason)}); }

}  // namespace

double total_mass(const Body& body) {
  double total = 0;
  for (const double mass : body.masses) total += mass;
  return total;
}

Result<Position> centre_of_mass(const Body& body) {
  if (const auto checked = check_body(body); !checked) return tl::unexpected(checked.error());
  const double total = total_mass(body);
  Position centre{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double rest = 0;  // about the first particle, so that a distance from the origin costs no digits
    const double first = body.positions[axis][0];
    for (std::size_t k = 0; k < body.size(); ++k)
      rest += body.masses[k] / total * (body.positions[axis][k] - first);
    centre[axis] = first + rest;
    if (!std::isfinite(centre[axis])) return refuse("the centre of mass overflows");
  }
  return centre;
}

Result<InertiaTensor> inertia_tensor(const Body& body) {
  const auto centre = centre_of_mass(body);
  if (!centre) return tl::unexpected(centre.error());
  std::array<double, 3> squares{};   // Σ m x_i²
  std::array<double, 3> products{};  // Σ m x_j x_k, by the axis i that is left out
  for (std::size_t k = 0; k < body.size(); ++k) {
    Position r = body.position(k);
    for (std::size_t i = 0; i < 3; ++i) r[i] -= (*centre)[i];
    for (std::size_t i = 0; i < 3; ++i) {
      squares[i] += body.masses[k] * (r[i] * r[i]);
      products[i] += body.masses[k] * (r[(i + 1) % 3] * r[(i + 2) % 3]);
    }
  }
  InertiaTensor inertia{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    inertia[i][i] = squares[j] + squares[k];
    inertia[j][k] = inertia[k][j] = 0 - products[i];
    if (!std::isfinite(inertia[i][i]) || !std::isfinite(inertia[j][k]))
      return refuse("the inertia tensor overflows");
  }
  return inertia;
}

}  // namespace rigor
