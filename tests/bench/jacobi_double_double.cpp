// SPDX-License-Identifier: GPL-3.0-or-later
#include "jacobi_double_double.h"

#include <qd/dd_real.h>

#include <algorithm>
#include <cmath>

namespace rigor {
namespace {

using Matrix = std::array<std::array<dd_real, 3>, 3>;

void rotate(Matrix& a, Matrix& axes, std::size_t p, std::size_t q) {
  const dd_real tau = (a[q][q] - a[p][p]) / (2.0 * a[p][q]);
  const dd_real t = (tau.is_negative() ? -1.0 : 1.0) / (abs(tau) + sqrt(1.0 + sqr(tau)));
  const dd_real c = 1.0 / sqrt(1.0 + sqr(t));
  const dd_real s = t * c;
  const std::size_t r = 3 - p - q;
  a[p][p] -= t * a[p][q];
  a[q][q] += t * a[p][q];
  a[p][q] = a[q][p] = 0.0;
  const dd_real x = a[r][p];
  a[r][p] = a[p][r] = c * x - s * a[r][q];
  a[r][q] = a[q][r] = s * x + c * a[r][q];
  for (std::size_t k = 0; k < 3; ++k) {
    const dd_real v = axes[k][p];
    axes[k][p] = c * v - s * axes[k][q];
    axes[k][q] = s * v + c * axes[k][q];
  }
}

}  // namespace

void jacobi_double_double(const InertiaTensor& tensor, Position& moments, Position& gaps,
                          std::array<Position, 3>& axes) {
  double greatest = 0;
  for (const Position& row : tensor)
    for (const double x : row) greatest = std::max(greatest, std::abs(x));
  const int exponent = greatest > 0 ? std::ilogb(greatest) : 0;
  Matrix a;
  Matrix v;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      a[i][j] = std::scalbn(tensor[i][j], -exponent);
      v[i][j] = i == j ? 1.0 : 0.0;
    }
  }
  for (int sweep = 0; sweep < 10; ++sweep) {
    bool done = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t p = i == 2 ? 0 : i;
      const std::size_t q = i == 2 ? 2 : i + 1;
      if (std::abs(a[p][q].x[0]) <= 1e-33) continue;
      rotate(a, v, p, q);
      done = false;
    }
    if (done) break;
  }
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return a[i][i] < a[j][j]; });
  for (std::size_t k = 0; k < 3; ++k) {
    moments[k] = std::scalbn(a[order[k]][order[k]].x[0], exponent);
    for (std::size_t i = 0; i < 3; ++i) axes[k][i] = v[i][order[k]].x[0];
  }
  const auto gap = [&](std::size_t i, std::size_t j) {
    return std::scalbn((a[order[i]][order[i]] - a[order[j]][order[j]]).x[0], exponent);
  };
  gaps = {gap(1, 0), gap(2, 1), gap(2, 0)};
}

}  // namespace rigor
