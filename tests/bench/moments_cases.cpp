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
  double residual = 0;  // |A n − λ n| / |n| in u |A|, long double; infinite where an axis is not of length 1
  double orthonormal = 0;  // |n_k·n_l − δ_kl| in u

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
      if (!axes) continue;
      residual = std::max(residual, residual_of(tensor, solved, k, norm));
      for (std::size_t l = 0; l <= k; ++l)
        orthonormal = std::max(orthonormal, in_units(std::abs(dot(solved, k, l) - (k == l ? 1 : 0))));
    }
  }

  static long double dot(const SolvedMoments& solved, std::size_t k, std::size_t l) {
    long double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
      sum += static_cast<long double>(solved.axes[k][i]) * solved.axes[l][i];
    return sum;
  }

  static double in_units(long double error) {
    return std::isfinite(error) ? static_cast<double>(error * 0x1p53L)
                                : std::numeric_limits<double>::infinity();
  }

  static double residual_of(const InertiaTensor& tensor, const SolvedMoments& solved, std::size_t k,
                            long double norm) {
    constexpr long double most_off =
        0x1p-40L;  // far beyond rounding; what is nearer is divided by its length
    const long double square = dot(solved, k, k);
    if (!(std::abs(square - 1) <= most_off)) return std::numeric_limits<double>::infinity();
    if (norm == 0) return 0;
    long double rest_square = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      long double rest = -static_cast<long double>(solved.moments[k]) * solved.axes[k][i];
      for (std::size_t j = 0; j < 3; ++j) rest += static_cast<long double>(tensor[i][j]) * solved.axes[k][j];
      // the last place of subnormal moments
      rest = std::max(std::abs(rest) - 0x1p-1074L, 0.0L) / norm;
      rest_square += rest * rest;
    }
    return in_units(std::sqrt(rest_square / square));
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
      if (!axes) continue;
      rows.push_back({"residual of axes", solver.name, family.name, row.nanoseconds,
                      errors.residual * 0x1p-53, fmt::format("{:.1f} u", errors.residual)});
      rows.push_back({"orthonormality of axes", solver.name, family.name, row.nanoseconds,
                      errors.orthonormal * 0x1p-53, fmt::format("{:.1f} u", errors.orthonormal)});
    }
    if (const std::string missing = missing_solver(); !missing.empty()) {
      const double infinite = std::numeric_limits<double>::infinity();
      rows.push_back({"moments", missing, family.name, infinite, infinite, "not installed"});
    }
  }
  return rows;
}

}  // namespace rigor
