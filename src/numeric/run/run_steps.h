// SPDX-License-Identifier: GPL-3.0-or-later
// The steps of a program on doubles, in lanes as wide as the machine has them. Compiled once for each
// instruction set, with the same bits in all: every operation is one of IEEE 754, and none is fused.
#pragma once

#include <string_view>

#include "numeric/program/run_plan.h"

namespace rigor {

/// How many particles a wide slot holds. So that the order of sums does not depend on the instruction set, it
/// is the same in all.
inline constexpr int lane_count = 128;
/// As many lanes are computed at least, so that no instruction set leaves other numbers than another in lanes
/// that do not count.
inline constexpr int lane_step = 8;

/// `lanes`: how many of them count; the others, up to a multiple of `lane_step`, may be computed, too, but
/// are not added to.
template <class T>
using StepFunction = void (*)(T* const* slots, const PlanStep& step, int lanes);

/// What computes a step; null where nothing is wide, and for functions of the standard library.
using FindStep = StepFunction<double> (*)(const PlanStep& step);

/// For an instruction set by its name; for the baseline where this program was not built with it.
[[nodiscard]] FindStep steps_of(std::string_view instruction_set);

/// For that of `lane_kernels()`.
[[nodiscard]] FindStep wide_steps();

}  // namespace rigor
