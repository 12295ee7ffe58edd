// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "numeric/run/run_decimal.h"

namespace rigor {

/// Moments and axes of a symmetric tensor (its lower triangle is read) by 14 sweeps of Jacobi's rotations in
/// numbers of many digits.
template <class Digits>
struct JacobiReference {
  std::array<Digits, 3> moments;              // ascending
  std::array<std::array<Digits, 3>, 3> axes;  // in their order

  template <class Tensor>
  explicit JacobiReference(const Tensor& tensor) {
    std::array<std::array<Digits, 3>, 3> a;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        a[i][j] = tensor[std::max(i, j)][std::min(i, j)];
        axes[i][j] = i == j ? 1 : 0;
      }
    }
    for (int sweep = 0; sweep < 14; ++sweep) {
      for (const auto& [p, q] : {std::array<std::size_t, 2>{0, 1}, {0, 2}, {1, 2}}) {
        if (a[p][q] == 0) continue;
        const Digits tau = (a[q][q] - a[p][p]) / (2 * a[p][q]);
        const Digits t = (tau < 0 ? -1 : 1) / (abs(tau) + sqrt(1 + tau * tau));
        const Digits c = 1 / sqrt(1 + t * t);
        const Digits s = t * c;
        for (std::size_t k = 0; k < 3; ++k) {
          const Digits x = a[k][p];
          a[k][p] = c * x - s * a[k][q];
          a[k][q] = s * x + c * a[k][q];
          const Digits y = axes[p][k];
          axes[p][k] = c * y - s * axes[q][k];
          axes[q][k] = s * y + c * axes[q][k];
        }
        for (std::size_t k = 0; k < 3; ++k) {
          const Digits x = a[p][k];
          a[p][k] = c * x - s * a[q][k];
          a[q][k] = s * x + c * a[q][k];
        }
        a[p][q] = a[q][p] = 0;
      }
    }
    for (const auto& [i, j] : {std::pair{0U, 1U}, {1U, 2U}, {0U, 1U}}) {
      if (!(a[j][j] < a[i][i])) continue;
      std::swap(a[i][i], a[j][j]);
      std::swap(axes[i], axes[j]);
    }
    for (std::size_t k = 0; k < 3; ++k) moments[k] = a[k][k];
  }
};

}  // namespace rigor
