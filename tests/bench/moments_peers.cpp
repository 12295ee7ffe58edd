// SPDX-License-Identifier: GPL-3.0-or-later
#include "moments_peers.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <limits>
#include <memory>

#include "ginac_moments.h"
#include "jacobi_double_double.h"
#include "numeric/kernels/principal_moments.h"

#ifdef RIGOR_LAPACK
extern "C" void dsyev_(const char* job, const char* triangle, const int* size, double* matrix,
                       const int* stride, double* values, double* work, const int* work_size, int* info);
#endif

namespace rigor {
namespace {

Position differences(const Position& moments) {
  return {moments[1] - moments[0], moments[2] - moments[1], moments[2] - moments[0]};
}

/// A solver that takes one tensor after the other from `In` to `SolvedMoments`.
template <class In, class Convert, class Solve>
MomentSolver one_by_one(std::string table, std::string name, const Convert& convert, const Solve& solve) {
  struct Batch {
    std::vector<In> in;
    std::vector<SolvedMoments> out;
  };
  const auto batch = std::make_shared<Batch>();
  MomentSolver solver;
  solver.table = std::move(table);
  solver.name = std::move(name);
  solver.load = [batch, convert](const std::vector<InertiaTensor>& tensors) {
    batch->in.clear();
    for (const InertiaTensor& tensor : tensors) batch->in.push_back(convert(tensor));
    batch->out.assign(tensors.size(), {});
  };
  solver.run = [batch, solve] {
    for (std::size_t n = 0; n < batch->in.size(); ++n) solve(batch->in[n], batch->out[n]);
  };
  solver.result = [batch](std::size_t n) { return batch->out[n]; };
  return solver;
}

Eigen::Matrix3d to_eigen(const InertiaTensor& tensor) {
  Eigen::Matrix3d matrix;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      matrix(i, j) = tensor[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  return matrix;
}

using EigenSolver3 = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>;

void take(const EigenSolver3& from, bool axes, SolvedMoments& to) {
  for (std::size_t k = 0; k < 3; ++k) to.moments[k] = from.eigenvalues()[static_cast<int>(k)];
  to.gaps = differences(to.moments);
  if (!axes) return;
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t i = 0; i < 3; ++i)
      to.axes[k][i] = from.eigenvectors()(static_cast<int>(i), static_cast<int>(k));
}

MomentSolver eigen_compute(bool axes) {
  return one_by_one<Eigen::Matrix3d>(axes ? "axes" : "moments", "Eigen compute", to_eigen,
                                     [axes](const Eigen::Matrix3d& in, SolvedMoments& out) {
                                       EigenSolver3 solver;
                                       solver.compute(
                                           in, axes ? Eigen::ComputeEigenvectors : Eigen::EigenvaluesOnly);
                                       take(solver, axes, out);
                                     });
}

MomentSolver eigen_direct(bool axes) {
  return one_by_one<Eigen::Matrix3d>(axes ? "axes" : "moments", "Eigen computeDirect", to_eigen,
                                     [axes](const Eigen::Matrix3d& in, SolvedMoments& out) {
                                       EigenSolver3 solver;
                                       solver.computeDirect(
                                           in, axes ? Eigen::ComputeEigenvectors : Eigen::EigenvaluesOnly);
                                       take(solver, axes, out);
                                     });
}

#ifdef RIGOR_LAPACK
MomentSolver lapack(bool axes) {
  return one_by_one<InertiaTensor>(
      axes ? "axes" : "moments", "LAPACK dsyev", [](const InertiaTensor& tensor) { return tensor; },
      [axes](const InertiaTensor& in, SolvedMoments& out) {
        InertiaTensor matrix = in;
        const int size = 3;
        std::array<double, 102> work{};  // (32 + 2) 3
        const int work_size = static_cast<int>(work.size());
        int info = 0;
        dsyev_(axes ? "V" : "N", "L", &size, matrix[0].data(), &size, out.moments.data(), work.data(),
               &work_size, &info);
        out.gaps = differences(out.moments);
        if (axes) out.axes = matrix;  // the columns, one after the other
      });
}
#endif

MomentSolver double_double() {
  MomentSolver solver = one_by_one<InertiaTensor>(
      "axes", "Jacobi, double-double", [](const InertiaTensor& tensor) { return tensor; },
      [](const InertiaTensor& in, SolvedMoments& out) {
        jacobi_double_double(in, out.moments, out.gaps, out.axes);
      });
  solver.most = 512;
  return solver;
}

MomentSolver ginac() {
  const auto formula = std::make_shared<GinacMoments>();
  MomentSolver solver = one_by_one<InertiaTensor>(
      "moments", "GiNaC subs, evalf", [](const InertiaTensor& tensor) { return tensor; },
      [formula](const InertiaTensor& in, SolvedMoments& out) {
        out.moments = formula->evaluate(in);
        out.gaps = differences(out.moments);
      });
  solver.most = 32;
  return solver;
}

/// The kernel on columns, with or without axes.
MomentSolver kernel(const LaneKernels& lanes, bool axes) {
  struct Batch {
    std::array<std::vector<double>, 25> columns;
    MomentsColumns all;
  };
  const auto batch = std::make_shared<Batch>();
  MomentSolver solver;
  solver.table = axes ? "axes" : "moments";
  solver.name = &lanes == &lane_kernels() ? "kernel" : std::string("kernel, ") + lanes.instruction_set;
  solver.load = [batch, axes](const std::vector<InertiaTensor>& tensors) {
    for (auto& column : batch->columns) column.assign(tensors.size(), 0);
    MomentsColumns& all = batch->all;
    all = {};
    all.count = tensors.size();
    std::size_t next = 0;
    const auto column = [&] { return batch->columns[next++].data(); };
    for (std::size_t i = 0; i < 3; ++i) {
      double* const diagonal = column();
      double* const off = column();
      for (std::size_t n = 0; n < tensors.size(); ++n) {
        diagonal[n] = tensors[n][i][i];
        off[n] = tensors[n][(i + 1) % 3][(i + 2) % 3];
      }
      all.diagonal[i] = diagonal;
      all.off[i] = off;
      all.moments[i] = column();
      if (i < 2) all.gaps[i] = column();
      for (std::size_t k = 0; axes && k < 3; ++k) all.axes[i][k] = column();
    }
    all.state = column();
  };
  solver.run = [batch, &lanes] { solve_principal_moments(batch->all, lanes); };
  solver.result = [batch, axes](std::size_t n) {
    const MomentsColumns& all = batch->all;
    SolvedMoments solved;
    for (std::size_t k = 0; k < 3; ++k) {
      solved.moments[k] = all.moments[k][n];
      for (std::size_t i = 0; axes && i < 3; ++i) solved.axes[k][i] = all.axes[k][i][n];
    }
    solved.gaps = {all.gaps[0][n], all.gaps[1][n], all.gaps[0][n] + all.gaps[1][n]};
    return solved;
  };
  return solver;
}

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr SolvedMoments not_solved{{nan, nan, nan}, {nan, nan, nan}, {}};

MomentSolver kernel_one_by_one(bool axes) {
  return one_by_one<InertiaTensor>(
      axes ? "axes" : "moments", "kernel, single", [](const InertiaTensor& tensor) { return tensor; },
      [axes](const InertiaTensor& in, SolvedMoments& out) {
        const auto take_moments = [&](const RoundedMoments& from) {
          out.moments = from.moments;
          out.gaps = {from.gap(1, 0), from.gap(2, 1), from.gap(2, 0)};
        };
        out = not_solved;
        if (axes) {
          const auto solved = principal_axes(in);
          if (!solved) return;
          take_moments(solved->principal.rounded());
          out.axes = solved->axes;
        } else if (const auto solved = principal_moments(in)) {
          take_moments(*solved);
        }
      });
}

}  // namespace

std::vector<MomentSolver> moment_solvers() {
  std::vector<MomentSolver> solvers;
  for (const bool axes : {false, true}) {
    solvers.push_back(eigen_compute(axes));
    solvers.push_back(eigen_direct(axes));
#ifdef RIGOR_LAPACK
    solvers.push_back(lapack(axes));
#endif
    solvers.push_back(kernel(lane_kernels(), axes));
    for (const LaneKernels* lanes : runnable_lane_kernels())
      if (lanes != &lane_kernels()) solvers.push_back(kernel(*lanes, axes));
    solvers.push_back(kernel_one_by_one(axes));
  }
  solvers.push_back(double_double());
  solvers.push_back(ginac());
  return solvers;
}

std::string missing_solver() {
#ifdef RIGOR_LAPACK
  return "";
#else
  return "LAPACK dsyev";
#endif
}

}  // namespace rigor
