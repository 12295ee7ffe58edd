// SPDX-License-Identifier: GPL-3.0-or-later
// The characteristic polynomial λ³ − c₂λ² + c₁λ − c₀ of a symmetric 3×3 tensor of integers, exactly. What it
// needs of bits: 3 times those of the entries and 3 for the coefficients, 6 times and 20 for the
// discriminant.
#pragma once

#include <array>
#include <cstddef>

namespace rigor {

template <class Integer>
struct ExactCharacteristic {
  Integer c2 = 0;
  Integer c1 = 0;
  Integer c0 = 0;
  // Of the deviator 3a − c₂ 1: t³ − 3pt − q.
  Integer p;
  Integer q;

  explicit ExactCharacteristic(const std::array<std::array<Integer, 3>, 3>& a) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      const std::size_t k = (i + 2) % 3;
      c2 += a[i][i];
      c1 += a[i][i] * a[j][j] - a[i][j] * a[i][j];
      c0 += a[0][i] * (a[1][j] * a[2][k] - a[1][k] * a[2][j]);
    }
    p = c2 * c2 - 3 * c1;
    q = 2 * c2 * c2 * c2 - 9 * c2 * c1 + 27 * c0;
  }

  /// The squared product of the differences of the roots, times 27.
  [[nodiscard]] Integer discriminant_27() const { return 4 * p * p * p - q * q; }
};

}  // namespace rigor
