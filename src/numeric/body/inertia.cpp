// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/body/inertia.h"

#include <cmath>

#include "numeric/lane/double_double.h"

namespace rigor {

double total_mass(const Body& body) {
  baseline::CompensatedSum<double> total;
  for (const double mass : body.masses) total.add(mass);
  return std::isfinite(total.high) ? total.value().high : total.high;  // the low part of infinity is NaN
}

Result<InertiaTensor> inertia_tensor(const Body& body) {
  return check_count(body).and_then([&] { return mass_sums(points_of(body)); }).map(&MassSums::inertia);
}

}  // namespace rigor
