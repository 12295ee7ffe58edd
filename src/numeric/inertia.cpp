// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/inertia.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <utility>

#include "numeric/kernels/double_double.h"

namespace rigor {
namespace {

tl::unexpected<Error> refuse(std::string reason) { return tl::unexpected(Error{std::move(reason)}); }

Result<Eigen::Matrix3d> matrix_of(const InertiaTensor& inertia) {
  Eigen::Matrix3d matrix;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const double value = inertia[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      if (!std::isfinite(value)) return refuse("the inertia tensor is not finite");
      matrix(i, j) = value;
    }
  }
  return matrix;
}

Result<Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>> solved(const InertiaTensor& inertia, int options) {
  const auto matrix = matrix_of(inertia);
  if (!matrix) return tl::unexpected(matrix.error());
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(*matrix, options);
  if (solver.info() != Eigen::Success) return refuse("the principal moments did not converge");
  return solver;
}

Position position_of(const Eigen::Vector3d& vector) { return {vector[0], vector[1], vector[2]}; }

Eigen::Vector3d with_positive_peak(const Eigen::Vector3d& axis) {
  Eigen::Index peak = 0;
  axis.cwiseAbs().maxCoeff(&peak);
  return axis[peak] < 0 ? Eigen::Vector3d(-axis) : axis;
}

}  // namespace

double total_mass(const Body& body) {
  baseline::CompensatedSum<double> total;
  for (const double mass : body.masses) total.add(mass);
  return total.value().high;
}

Result<Position> centre_of_mass(const Body& body) {
  if (const auto checked = check_count(body); !checked) return tl::unexpected(checked.error());
  const auto centre = sharp_centre_of_mass(points_of(body));
  if (!centre) return tl::unexpected(centre.error());
  return Position{(*centre)[0].high, (*centre)[1].high, (*centre)[2].high};
}

Result<InertiaTensor> inertia_tensor(const Body& body) {
  if (const auto checked = check_count(body); !checked) return tl::unexpected(checked.error());
  const auto sums = mass_sums(points_of(body));
  if (!sums) return tl::unexpected(sums.error());
  return sums->inertia;
}

Result<SharpTensor> sharp_inertia_tensor(const Body& body) {
  if (const auto checked = check_count(body); !checked) return tl::unexpected(checked.error());
  const auto sums = sharp_mass_sums(points_of(body));
  if (!sums) return tl::unexpected(sums.error());
  return sums->inertia;
}

Result<Position> principal_moments(const InertiaTensor& inertia) {
  const auto solver = solved(inertia, Eigen::EigenvaluesOnly);
  if (!solver) return tl::unexpected(solver.error());
  return position_of(solver->eigenvalues());
}

Result<PrincipalAxes> principal_axes(const InertiaTensor& inertia) {
  const auto solver = solved(inertia, Eigen::ComputeEigenvectors);
  if (!solver) return tl::unexpected(solver.error());
  const Eigen::Vector3d first = with_positive_peak(solver->eigenvectors().col(0));
  const Eigen::Vector3d second = with_positive_peak(solver->eigenvectors().col(1));
  return PrincipalAxes{position_of(solver->eigenvalues()),
                       {position_of(first), position_of(second), position_of(first.cross(second))}};
}

}  // namespace rigor
