// SPDX-License-Identifier: GPL-3.0-or-later
// An assumption holds at all times. If it contains the time itself, as `at + b = 0` does, its coefficients
// can be compared: its derivatives give them, and so does the moment t = 0. This is not done for places:
// `\mathbf n\cdot\mathbf r = 0` can be meant at all places or on a plane.
#pragma once

#include <optional>
#include <vector>

#include "check/question/question.h"

namespace rigor {

/// Does the equation treat the time as running? It must also have a quantity that is said to be constant or
/// to change, and none that is defined as a number: `x = vt` next to `x = 5` is about one moment.
[[nodiscard]] bool runs_with_time(const ExprTree& tree, const Names& names, const Equation& equation);

/// The equation at t = 0, where it speaks of the time, all else in it is constant, and nothing divides by it.
[[nodiscard]] std::optional<Equation> at_time_zero(ExprTree& tree, const Names& names,
                                                   const Equation& equation);

/// An assumption of the question that contains the time or place itself, while no quantity is left that could
/// follow it; null if there is none. Each equation takes one changing quantity of its own.
[[nodiscard]] const NamedAssumption* unmatched_assumption(const ExprTree& tree, const Names& names,
                                                          const Prepared& prepared);

/// A moment (or place) that is like any other, as far as the equations speak of it outside functions: to be
/// assumed where only one is looked at.
[[nodiscard]] std::vector<Equation> somewhere(ExprTree& tree, const Names& names,
                                              const std::vector<Equation>& equations, By by);

}  // namespace rigor
