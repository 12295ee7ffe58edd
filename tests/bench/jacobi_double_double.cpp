// SPDX-License-Identifier: GPL-3.0-or-later
#include "jacobi_double_double.h"

#include <qd/dd_real.h>

#include <algorithm>
#include <cmath>

#include "numeric/kernels/rotations.h"

namespace rigor {

void jacobi_double_double(const InertiaTensor& tensor, Position& moments, Position& gaps,
                          std::array<Position, 3>& axes) {
  double greatest = 0;
  for (const Position& row : tensor)
    for (const double x : row) greatest = std::max(greatest, std::abs(x));
  const int exponent = greatest > 0 ? std::ilogb(greatest) : 0;
  Rotated<dd_real> r;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) r.a[i][j] = std::scalbn(tensor[i][j], -exponent);
  r.diagonalise(1e-33);
  for (std::size_t k = 0; k < 3; ++k) {
    moments[k] = std::scalbn(r.a[k][k].x[0], exponent);
    for (std::size_t i = 0; i < 3; ++i) axes[k][i] = r.axes[k][i].x[0];
  }
  const auto gap = [&](std::size_t i, std::size_t j) {
    return std::scalbn((r.a[i][i] - r.a[j][j]).x[0], exponent);
  };
  gaps = {gap(1, 0), gap(2, 1), gap(2, 0)};
}

}  // namespace rigor
