// SPDX-License-Identifier: GPL-3.0-or-later
// Can a rigid body have these moments? Decided in quadruple-double arithmetic (200 bits), in which three
// factors of 53 bits are multiplied and added without a rounding that could matter.
#include <fmt/format.h>
#include <qd/qd_real.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "numeric/body/body.h"

namespace rigor {
namespace {

using Exact = std::array<std::array<qd_real, 3>, 3>;

double unit_in_last_place(double value) {
  return std::nextafter(value, std::numeric_limits<double>::infinity()) - value;
}

/// No negative eigenvalue: all principal minors are at least 0.
bool is_positive_semidefinite(const Exact& a) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (a[i][i] < 0.0 || a[i][i] * a[j][j] - a[i][j] * a[j][i] < 0.0) return false;
  }
  qd_real determinant = 0.0;
  for (std::size_t j = 0; j < 3; ++j) {
    const std::size_t k = (j + 1) % 3;
    const std::size_t l = (j + 2) % 3;
    determinant += a[0][j] * (a[1][k] * a[2][l] - a[1][l] * a[2][k]);
  }
  return !(determinant < 0.0);
}

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
  const double tolerance = 2 * unit_in_last_place(std::scalbn(greatest, scale));
  const auto at = [&](std::size_t i, std::size_t j) { return qd_real(std::scalbn(inertia[i][j], scale)); };
  const qd_real half_trace = (at(0, 0) + at(1, 1) + at(2, 2)) * 0.5;
  Exact second_moments;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      second_moments[i][j] = i == j ? half_trace - at(i, i) + tolerance : -at(i, j);
  }
  if (!is_positive_semidefinite(second_moments))
    return refuse("a principal moment of the inertia tensor is greater than the sum of the others");
  return {};
}

}  // namespace rigor
