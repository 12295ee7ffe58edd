// SPDX-License-Identifier: GPL-3.0-or-later
// Tensors in columns with room for what is solved for, and what to compare it with.
#pragma once

#include <vector>

#include "numeric/kernels/moment_families.h"
#include "numeric/kernels/principal_moments.h"

namespace rigor {

inline constexpr double unit_roundoff = 0x1p-53;

[[nodiscard]] inline Digits50 size_of(const InertiaTensor& tensor) {
  Digits50 sum = 0;
  for (const Position& row : tensor)
    for (const double x : row) sum += Digits50(x) * x;
  return sqrt(sum);
}

/// Tensors as columns, with room for all results.
struct SolvedMoments {
  std::vector<std::vector<double>> in;
  std::vector<std::vector<double>> out;
  MomentsColumns columns;

  explicit SolvedMoments(const std::vector<InertiaTensor>& tensors) : in(6), out(18) {
    for (const InertiaTensor& tensor : tensors) {
      for (std::size_t i = 0; i < 3; ++i) {
        in[i].push_back(tensor[i][i]);
        in[3 + i].push_back(tensor[(i + 1) % 3][(i + 2) % 3]);
      }
    }
    set_columns(tensors.size());
  }

  explicit SolvedMoments(const std::vector<SharpTensor>& tensors) : in(12), out(18) {
    for (const SharpTensor& tensor : tensors) {
      for (std::size_t i = 0; i < 3; ++i) {
        const HighLow& off = tensor[(i + 1) % 3][(i + 2) % 3];
        in[i].push_back(tensor[i][i].high);
        in[3 + i].push_back(off.high);
        in[6 + i].push_back(tensor[i][i].low);
        in[9 + i].push_back(off.low);
      }
    }
    set_columns(tensors.size());
    for (std::size_t i = 0; i < 3; ++i) {
      columns.diagonal_low[i] = in[6 + i].data();
      columns.off_low[i] = in[9 + i].data();
    }
  }

  void set_columns(std::size_t count) {
    for (auto& column : out) column.resize(count, -1);
    columns.count = count;
    for (std::size_t i = 0; i < 3; ++i) {
      columns.diagonal[i] = in[i].data();
      columns.off[i] = in[3 + i].data();
      columns.moments[i] = out[i].data();
      columns.moments_low[i] = out[3 + i].data();
      for (std::size_t k = 0; k < 3; ++k) columns.axes[i][k] = out[9 + 3 * i + k].data();
    }
    columns.gaps[0] = out[6].data();
    columns.gaps[1] = out[7].data();
    columns.state = out[8].data();
  }

  [[nodiscard]] Position axis(std::size_t k, std::size_t at) const {
    return {columns.axes[k][0][at], columns.axes[k][1][at], columns.axes[k][2][at]};
  }
};

[[nodiscard]] inline PrincipalReference reference_of(const SharpTensor& tensor) {
  std::array<std::array<Decimal<100>, 3>, 3> exact;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) exact[i][j] = Decimal<100>(tensor[i][j].high) + tensor[i][j].low;
  return principal_reference_of_digits(exact);
}

}  // namespace rigor
