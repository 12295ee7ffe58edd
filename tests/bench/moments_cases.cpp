// SPDX-License-Identifier: GPL-3.0-or-later
#include "moments_cases.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench_clock.h"
#include "moments_peers.h"
#include "numeric/kernels/moment_families.h"

namespace rigor {
namespace {

constexpr std::size_t tensors_at_once = 2048;

struct MomentErrors {
  double gaps = 0;
  double moments = 0;
  double residual = 0;  // |A n − λ n| in u |A|, long double

  void widen(const InertiaTensor& tensor, const PrincipalReference& exact, const SolvedMoments& solved,
             bool axes) {
    long double square = 0;
    for (const Position& row : tensor)
      for (const double x : row) square += static_cast<long double>(x) * x;
    const long double norm = std::sqrt(square);
    for (std::size_t k = 0; k < 3; ++k) {
      gaps = std::max(gaps, relative_error(solved.gaps[k], exact.gaps[k], static_cast<double>(norm)));
      moments =
          std::max(moments, relative_error(solved.moments[k], exact.moments[k], static_cast<double>(norm)));
      if (axes && norm > 0) residual = std::max(residual, residual_of(tensor, solved, k, norm));
    }
  }

  static double residual_of(const InertiaTensor& tensor, const SolvedMoments& solved, std::size_t k,
                            long double norm) {
    long double rest_square = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      long double rest = -static_cast<long double>(solved.moments[k]) * solved.axes[k][i];
      for (std::size_t j = 0; j < 3; ++j) rest += static_cast<long double>(tensor[i][j]) * solved.axes[k][j];
      // the last place of subnormal moments
      rest = std::max(std::abs(rest) - 0x1p-1074L, 0.0L) / norm;
      rest_square += rest * rest;
    }
    const auto result = static_cast<double>(std::sqrt(rest_square) * 0x1p53L);
    return std::isnan(result) ? std::numeric_limits<double>::infinity() : result;
  }
};

}  // namespace

std::vector<KernelRow> moments_rows() {
  const std::vector<MomentSolver> solvers = moment_solvers();
  std::vector<KernelRow> rows;
  for (const MomentFamily& family : moment_families(tensors_at_once)) {
    std::vector<PrincipalReference> exact;
    for (const InertiaTensor& tensor : family.tensors) exact.push_back(principal_reference(tensor));
    for (const MomentSolver& solver : solvers) {
      const std::size_t count = std::min(solver.most, family.tensors.size());
      const bool axes = solver.table == "axes";
      solver.load({family.tensors.begin(), family.tensors.begin() + static_cast<std::ptrdiff_t>(count)});
      KernelRow row{solver.table, solver.name, family.name, 0, 0, ""};
      row.nanoseconds = least_nanoseconds(solver.run) / static_cast<double>(count);
      MomentErrors errors;
      for (std::size_t n = 0; n < count; ++n)
        errors.widen(family.tensors[n], exact[n], solver.result(n), axes);
      row.error = std::max(errors.gaps, errors.moments);
      row.remark = fmt::format("gaps {:.1e}, moments {:.1e}", errors.gaps, errors.moments);
      rows.push_back(row);
      if (axes)
        rows.push_back({"residual of axes", solver.name, family.name, row.nanoseconds,
                        errors.residual * 0x1p-53, fmt::format("{:.1f} u", errors.residual)});
    }
    if (const std::string missing = missing_solver(); !missing.empty()) {
      const double infinite = std::numeric_limits<double>::infinity();
      rows.push_back({"moments", missing, family.name, infinite, infinite, "not installed"});
    }
  }
  return rows;
}

}  // namespace rigor
