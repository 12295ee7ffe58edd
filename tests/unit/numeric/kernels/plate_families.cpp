// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/kernels/plate_families.h"

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "numeric/family/family_values.h"

namespace rigor {

bool is_valid_exactly(const InertiaTensor& inertia) {
  using Integer = boost::multiprecision::int1024_t;
  double greatest = 0;
  for (const Position& row : inertia)
    for (const double entry : row) greatest = std::max(greatest, std::abs(entry));
  const int unit = std::ilogb(greatest) - 52;
  const auto in_units = [&](double x) { return Integer(std::ldexp(x, 64 - unit)); };  // 2^-64 of the unit
  Integer trace = 0;
  for (std::size_t i = 0; i < 3; ++i) trace += in_units(inertia[i][i]);
  std::array<std::array<Integer, 3>, 3> a;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) a[i][j] = -2 * in_units(inertia[i][j]);
    a[i][i] += trace + 4 * in_units(std::ldexp(1, unit));
  }
  Integer determinant = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    if (a[i][i] < 0 || a[i][i] * a[j][j] < a[i][j] * a[j][i]) return false;
    determinant += a[0][i] * (a[1][j] * a[2][k] - a[1][k] * a[2][j]);
  }
  return determinant >= 0;
}

InertiaTensor nearly_a_plate(SplitMix& bits) {
  std::array<Position, 2> plane{};
  for (Position& direction : plane)
    for (double& x : direction) x = static_cast<double>(bits.below(41)) - 20;
  InertiaTensor inertia{};
  for (int point = 0; point < 5; ++point) {
    Position r{};
    for (const Position& direction : plane) {
      const double along = static_cast<double>(bits.below(41)) - 20;
      for (std::size_t i = 0; i < 3; ++i) r[i] += along * direction[i];
    }
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j)
        inertia[i][j] += (i == j ? r[0] * r[0] + r[1] * r[1] + r[2] * r[2] : 0) - r[i] * r[j];
    }
  }
  const double factor = draw_positive(bits);
  double greatest = 0;
  for (Position& row : inertia) {
    for (double& entry : row) {
      entry *= factor;
      greatest = std::max(greatest, std::abs(entry));
    }
  }
  const std::size_t which = bits.below(3);
  const double units = static_cast<double>(bits.below(25)) - 12;
  if (greatest > 0) inertia[which][which] += units * std::ldexp(1, std::ilogb(greatest) - 52);
  return inertia;
}

}  // namespace rigor
