// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/kernels/symmetric_top_families.h"

#include <cmath>
#include <utility>

#include "numeric/kernels/moment_families.h"
#include "numeric/program/uniform.h"

namespace rigor {
namespace {

/// Four points a quarter turn apart about the axis z, with a little more mass near x: integers, which the
/// matrix of the quaternion (1, 2, −1, 1) turns into integers.
void add_quarter_turns(NearlySymmetricTop& top, SplitMix& bits) {
  constexpr std::array<std::array<int, 3>, 3> turn{{{3, -6, 2}, {-2, -3, -6}, {6, 2, -3}}};
  const auto integer = [&](int most) {
    return static_cast<int>(bits.below(2 * static_cast<std::size_t>(most) + 1)) - most;
  };
  int x = integer(2000);
  int y = integer(2000);
  const int z = integer(4000);
  const double mass = 1 - uniform(bits);
  for (int quarter = 0; quarter < 4; ++quarter) {
    top.masses.push_back(std::abs(x) > std::abs(y) ? mass * (1 + 3 * top.gap) : mass);
    for (std::size_t i = 0; i < 3; ++i)
      top.positions[i].push_back((turn[i][0] * x + turn[i][1] * y + turn[i][2] * z) * 0x1p-15);
    x = -std::exchange(y, x);
  }
}

/// About the centre of mass, in 100 digits.
std::array<std::array<Decimal<100>, 3>, 3> inertia_of(const NearlySymmetricTop& top) {
  std::array<std::array<Decimal<100>, 3>, 3> inertia;
  Decimal<100> mass = 0;
  std::array<Decimal<100>, 3> centre;
  for (std::size_t n = 0; n < top.masses.size(); ++n) {
    mass += top.masses[n];
    for (std::size_t i = 0; i < 3; ++i) centre[i] += Decimal<100>(top.masses[n]) * top.positions[i][n];
  }
  for (Decimal<100>& x : centre) x /= mass;
  for (std::size_t n = 0; n < top.masses.size(); ++n) {
    std::array<Decimal<100>, 3> r;
    Decimal<100> square = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      r[i] = top.positions[i][n] - centre[i];
      square += r[i] * r[i];
    }
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        inertia[i][j] += top.masses[n] * ((i == j ? square : Decimal<100>(0)) - r[i] * r[j]);
  }
  return inertia;
}

void add_reference(NearlySymmetricTop& top) {
  const PrincipalReference exact = principal_reference_of_digits(inertia_of(top));
  const auto gap = [&](std::size_t i, std::size_t j) -> Digits50 {
    return i > j ? exact.gaps[i + j == 1   ? 0
                              : i + j == 3 ? 1
                                           : 2]
                 : -exact.gaps[i + j == 1   ? 0
                               : i + j == 3 ? 1
                                            : 2];
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    top.squared_frequencies[i] = gap(i, j) * gap(i, k) / (exact.moments[j] * exact.moments[k]);
  }
}

}  // namespace

std::vector<NearlySymmetricTop> nearly_symmetric_tops() {
  constexpr int points = 1024;
  std::vector<NearlySymmetricTop> tops;
  for (const char* gap : {"1e-2", "1e-5", "1e-8", "1e-11", "1e-13"}) {
    NearlySymmetricTop top;
    top.gap = std::stod(gap);
    SplitMix bits(1);
    for (int n = 0; n < points; n += 4) add_quarter_turns(top, bits);
    add_reference(top);
    for (const char* distance : {"0", "1e4", "1e8"}) {
      tops.push_back(top);
      tops.back().name = std::string("gap ") + gap + ", distance " + distance;
      tops.back().distance = std::stod(distance);
      for (auto& coordinates : tops.back().positions)
        for (double& x : coordinates) x += tops.back().distance;  // exact: multiples of 2^-15 below 2^38
    }
  }
  return tops;
}

}  // namespace rigor
