// SPDX-License-Identifier: GPL-3.0-or-later
#include "stability_cases.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <limits>

#include "bench_clock.h"
#include "numeric/kernels/mass_sums.h"
#include "numeric/kernels/moment_families.h"
#include "numeric/kernels/stability_frequencies.h"
#include "numeric/kernels/symmetric_top_families.h"

namespace rigor {
namespace {

/// The points as a programmer of Eigen has them.
struct EigenPoints {
  Eigen::Matrix3Xd positions;
  Eigen::VectorXd masses;
};

EigenPoints to_eigen(const NearlySymmetricTop& top) {
  EigenPoints points;
  const auto count = static_cast<Eigen::Index>(top.masses.size());
  points.masses = Eigen::Map<const Eigen::VectorXd>(top.masses.data(), count);
  points.positions.resize(3, count);
  for (int i = 0; i < 3; ++i)
    points.positions.row(i) =
        Eigen::Map<const Eigen::RowVectorXd>(top.positions[static_cast<std::size_t>(i)].data(), count);
  return points;
}

/// Two passes for the inertia tensor, its eigenvalues, their differences.
std::array<double, 3> obvious_frequencies(const EigenPoints& points, bool direct) {
  const Eigen::Vector3d centre = points.positions * points.masses / points.masses.sum();
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();
  for (Eigen::Index n = 0; n < points.masses.size(); ++n) {
    const Eigen::Vector3d r = points.positions.col(n) - centre;
    inertia += points.masses[n] * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  if (direct)
    solver.computeDirect(inertia, Eigen::EigenvaluesOnly);
  else
    solver.compute(inertia, Eigen::EigenvaluesOnly);
  const Eigen::Vector3d& m = solver.eigenvalues();
  std::array<double, 3> squares{};
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    squares[static_cast<std::size_t>(i)] = (m[i] - m[j]) * (m[i] - m[k]) / (m[j] * m[k]);
  }
  return squares;
}

std::array<double, 3> kernel_frequencies(const NearlySymmetricTop& top) {
  PointColumns points;
  for (std::size_t i = 0; i < 3; ++i) points.position[i] = top.positions[i].data();
  points.mass = top.masses.data();
  points.count = top.masses.size();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto sums = sharp_mass_sums(points);
  if (!sums) return {nan, nan, nan};
  const auto moments = principal_moments(sums->inertia);
  return moments ? squared_stability_frequencies(moments->rounded(), 1) : std::array{nan, nan, nan};
}

template <class Compute>
KernelRow row_of(const std::string& name, const NearlySymmetricTop& top, const Compute& compute) {
  KernelRow row{"points to stability frequency", name, top.name, 0, 0, ""};
  volatile double kept = 0;
  row.nanoseconds = least_nanoseconds([&] { kept = compute()[0]; });
  const std::array<double, 3> squares = compute();
  for (std::size_t i = 0; i < 3; ++i)
    row.error = std::max(row.error, relative_error(squares[i], top.squared_frequencies[i], 1));
  return row;
}

}  // namespace

std::vector<KernelRow> stability_rows() {
  std::vector<KernelRow> rows;
  for (const NearlySymmetricTop& top : nearly_symmetric_tops()) {
    const EigenPoints points = to_eigen(top);
    rows.push_back(
        row_of("Eigen, two passes, compute", top, [&] { return obvious_frequencies(points, false); }));
    rows.push_back(
        row_of("Eigen, two passes, computeDirect", top, [&] { return obvious_frequencies(points, true); }));
    rows.push_back(row_of("kernel", top, [&] { return kernel_frequencies(top); }));
  }
  return rows;
}

}  // namespace rigor
