// SPDX-License-Identifier: GPL-3.0-or-later
// The kernels that run in lanes, as they were compiled for one instruction set. All give the same bits, but
// for plain sums over points, which have one rounding less a term where there is a fused multiply-add. The
// widest set that the machine has is the fastest.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "numeric/lane/mesh_totals.h"
#include "numeric/lane/point_sums.h"

namespace rigor {

struct MomentsColumns;
struct FreeSpin;
struct FreeAttitude;
struct FreeBodies;

struct LaneKernels {
  const char* instruction_set = "";  // baseline, x86_64_v3 (AVX2, FMA), x86_64_v4 (AVX-512)
  std::size_t lanes = 0;             // doubles at once

  // mesh_sums.h
  MeshKernels mesh;

  // principal_moments.h
  void (*principal_moments)(const MomentsColumns&) = nullptr;
  /// By rows, of which the lower triangle is read; `sharp`: each entry with its low part behind it. The
  /// moments with their low parts likewise; the axes, unless that is null. Returns the state.
  double (*principal_moments_of_one)(const double* tensor, bool sharp, double* moments, double* gaps,
                                     double* axes) = nullptr;
  /// By rows. False if they do not lie apart, or cannot be rounded: then the kernels above find them.
  bool (*distinct_moments)(const double* tensor, double* moments, double* gaps) = nullptr;

  // mass_sums.h
  SumPoints sum_points = nullptr;
  SumPoints sum_points_sharply = nullptr;
  SamplePoints sample_points = nullptr;

  // torque_free.h
  void (*set_free_spin)(const double* moments, const double* spin, FreeSpin& into) = nullptr;
  void (*free_spin_at)(const FreeSpin& spin, double time, double* into) = nullptr;
  void (*free_spins_at)(const FreeSpin& spin, const double* times, std::size_t count, double* into) = nullptr;

  // torque_free_attitude.h
  void (*set_free_attitude)(const double* moments, const double* spin, FreeAttitude& into) = nullptr;
  void (*attitude_at)(const FreeAttitude& attitude, double time, double* into) = nullptr;
  void (*attitudes_at)(const FreeAttitude& attitude, const double* times, std::size_t count,
                       double* into) = nullptr;

  // torque_free_step.h
  std::size_t (*step_free_bodies)(const FreeBodies& bodies, std::size_t* beyond) = nullptr;
};

/// Those that this program was built with and this machine can run, from the narrowest to the widest. Never
/// empty.
[[nodiscard]] const std::vector<const LaneKernels*>& runnable_lane_kernels();

/// The set of that name if this machine can run it, else the widest.
[[nodiscard]] const LaneKernels& lane_kernels_named(std::string_view instruction_set);

/// Those that the environment variable RIGOR_INSTRUCTION_SET names, the widest without one: to measure, and
/// to get the last bits of plain sums that another machine gets.
[[nodiscard]] const LaneKernels& lane_kernels();

}  // namespace rigor
