// SPDX-License-Identifier: GPL-3.0-or-later
// Jacobi's rotations of a symmetric 3×3 tensor in numbers of many bits.
#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <utility>

#include "numeric/kernels/high_low.h"
#include "numeric/kernels/position.h"

namespace rigor {

template <unsigned bits>
using Binary = boost::multiprecision::number<
    boost::multiprecision::cpp_bin_float<bits, boost::multiprecision::digit_base_2>,
    boost::multiprecision::et_off>;

/// Eigenvalues with their axes, ascending, in numbers of so many bits.
template <class Number>
struct Rotated {
  std::array<std::array<Number, 3>, 3> a;  // diagonal at the end
  std::array<std::array<Number, 3>, 3> axes;

  /// Jacobi's rotation by which a_pq vanishes.
  void rotate(std::size_t p, std::size_t q) {
    if (a[p][q] == 0) return;
    const Number ratio = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    Number t = 1 / (abs(ratio) + sqrt(1 + ratio * ratio));
    if (ratio < 0) t = -t;
    const Number c = 1 / sqrt(1 + t * t);
    const Number s = c * t;
    const Number turned = t * a[p][q];
    a[p][p] -= turned;
    a[q][q] += turned;
    a[p][q] = a[q][p] = Number(0);
    const std::size_t r = 3 - p - q;
    const Number x = a[r][p];
    a[r][p] = a[p][r] = c * x - s * a[r][q];
    a[r][q] = a[q][r] = s * x + c * a[r][q];
    for (std::size_t i = 0; i < 3; ++i) {
      const Number y = axes[p][i];
      axes[p][i] = c * y - s * axes[q][i];
      axes[q][i] = s * y + c * axes[q][i];
    }
  }

  [[nodiscard]] Number greatest() const {
    Number size = 0;
    for (const auto& row : a) {
      for (const Number& entry : row) size = std::max<Number>(size, abs(entry));
    }
    return size;
  }

  /// To off-diagonal entries of at most `unit`, with ascending eigenvalues; from axes along those of `a`.
  void diagonalise(const Number& unit) {
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) axes[i][j] = Number(i == j ? 1 : 0);
    constexpr int most_sweeps = 64;
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
      if (abs(a[0][1]) <= unit && abs(a[1][2]) <= unit && abs(a[0][2]) <= unit) break;
      rotate(0, 1);
      rotate(0, 2);
      rotate(1, 2);
    }
    sort();
  }

 private:
  void sort() {
    for (const auto& [i, j] : {std::pair{0U, 1U}, {1U, 2U}, {0U, 1U}}) {
      if (a[j][j] < a[i][i]) {
        std::swap(a[i][i], a[j][j]);
        std::swap(axes[i], axes[j]);
      }
    }
  }
};

template <class Number>
[[nodiscard]] HighLow rounded(const Number& x) {
  const auto high = static_cast<double>(x);
  if (!std::isfinite(high)) return {high, 0};
  return {high, static_cast<double>(Number(x - high))};
}

/// The first two axes point to where their component of greatest size is positive; the third makes them
/// right-handed.
inline void orient(std::array<Position, 3>& axes) {
  for (std::size_t k = 0; k < 2; ++k) {
    double peak = axes[k][0];
    for (const double x : axes[k]) {
      if (std::abs(x) > std::abs(peak)) peak = x;
    }
    if (peak < 0) {
      for (double& x : axes[k]) x = 0 - x;
    }
  }
  double handed = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    handed += axes[2][i] * (axes[0][j] * axes[1][k] - axes[0][k] * axes[1][j]);
  }
  if (handed < 0) {
    for (double& x : axes[2]) x = 0 - x;
  }
}

}  // namespace rigor
