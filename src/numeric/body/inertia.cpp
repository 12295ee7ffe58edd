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

Result<Position> centre_of_mass(const Body& body) {
  if (const auto checked = check_count(body); !checked) return tl::unexpected(checked.error());
  const auto centre = sharp_centre_of_mass(points_of(body));
  if (!centre) return tl::unexpected(centre.error());
  return Position{(*centre)[0].high, (*centre)[1].high, (*centre)[2].high};
}

Result<InertiaTensor> inertia_tensor(const Body& body) {
  if (const auto checked = check_count(body); !checked) return tl::unexpected(checked.error());
  const auto sums = mass_sums(points_of(body));
  if (!sums) return tl::unexpected(sums.error());
  return sums->inertia;
}

Result<SharpTensor> sharp_inertia_tensor(const Body& body) {
  if (const auto checked = check_count(body); !checked) return tl::unexpected(checked.error());
  const auto sums = sharp_mass_sums(points_of(body));
  if (!sums) return tl::unexpected(sums.error());
  return sums->inertia;
}

}  // namespace rigor
