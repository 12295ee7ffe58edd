// SPDX-License-Identifier: GPL-3.0-or-later
// Can a rigid body have these moments? The excess of the greatest over the sum of the others is computed in
// quadruple-double arithmetic (200 bits), from moments to 2^-100 of the greatest.
#include <fmt/format.h>
#include <qd/qd_real.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "numeric/body.h"
#include "numeric/kernels/principal_moments.h"

namespace rigor {
namespace {

tl::unexpected<Error> refuse(std::string reason) { return tl::unexpected(Error{std::move(reason)}); }

double unit_in_last_place(double value) {
  return std::nextafter(value, std::numeric_limits<double>::infinity()) - value;
}

qd_real exact(const HighLow& x) { return qd_real(x.high) + x.low; }

}  // namespace

Result<void> check_moments(const Position& moments) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (!std::isfinite(moments[i]) || moments[i] < 0)
      return refuse(fmt::format("moment of inertia {} is {} kg m^2, which must be finite and not negative",
                                i + 1, moments[i]));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const qd_real excess = qd_real(moments[i]) - moments[j] - moments[k];
    if (excess > 4 * unit_in_last_place(moments[i]))
      return refuse(
          fmt::format("moment of inertia {} is {} kg m^2, greater than the sum of the others, {} and {}",
                      i + 1, moments[i], moments[j], moments[k]));
  }
  return {};
}

Result<void> check_inertia(const InertiaTensor& inertia) {
  double greatest = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (!std::isfinite(inertia[i][j]))
        return refuse(fmt::format("the inertia tensor has I_{}{} = {}, which must be finite", i + 1, j + 1,
                                  inertia[i][j]));
      if (inertia[i][j] != inertia[j][i])
        return refuse(fmt::format("the inertia tensor is not symmetric: I_{0}{1} = {2}, I_{1}{0} = {3}",
                                  i + 1, j + 1, inertia[i][j], inertia[j][i]));
      greatest = std::max(greatest, std::abs(inertia[i][j]));
    }
  }
  if (greatest == 0) return {};
  // Scaled to about 1, which is exact unless what is lost is beyond the tolerance.
  const int scale = -std::ilogb(greatest);
  InertiaTensor scaled = inertia;
  for (Position& row : scaled) {
    for (double& entry : row) entry = std::scalbn(entry, scale);
  }
  const auto principal = principal_moments(scaled);
  if (!principal) return tl::unexpected(principal.error());
  const auto& [least, middle, most] = principal->moments;
  // An excess of exactly the tolerance is accepted: the second term is what the moments may err by.
  const double tolerance = 4 * unit_in_last_place(std::scalbn(greatest, scale)) + 0x1p-90;
  if (exact(most) - exact(middle) - exact(least) > tolerance)
    return refuse("a principal moment of the inertia tensor is greater than the sum of the others");
  return {};
}

}  // namespace rigor
