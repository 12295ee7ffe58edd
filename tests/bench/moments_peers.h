// SPDX-License-Identifier: GPL-3.0-or-later
// Solvers for batches of symmetric 3×3 tensors under one interface.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "numeric/body/body.h"

namespace rigor {

/// Ascending. What is not finite was not solved.
struct SolvedMoments {
  Position moments{};
  Position gaps{};  // I₂ − I₁, I₃ − I₂, I₃ − I₁: differences where the solver has none
  std::array<Position, 3> axes{};  // of table "axes" only
};

struct MomentSolver {
  std::string table;  // "moments" or "axes"
  std::string name;
  std::size_t most = 2048;  // tensors at once; less for a slow one
  /// Prepares for these tensors, outside the time that is measured.
  std::function<void(const std::vector<InertiaTensor>&)> load;
  std::function<void()> run;
  std::function<SolvedMoments(std::size_t)> result;
};

/// Eigen, LAPACK if it was found, GiNaC, Jacobi in double-double, and the kernels.
[[nodiscard]] std::vector<MomentSolver> moment_solvers();

/// What is not built in: `LAPACK dsyev`; empty if nothing.
[[nodiscard]] std::string missing_solver();

}  // namespace rigor
