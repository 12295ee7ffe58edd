// SPDX-License-Identifier: GPL-3.0-or-later
// Initial and boundary conditions of a differential equation.
#pragma once

#include <vector>

#include "check/law/page_law.h"
#include "elaborate/name/names.h"

namespace rigor {

/// `x(0) = x_0`, `\dot x(0) = v_0`, `u(h) = 0`: what a function is at one place, or a derivative of it.
struct ValueCondition {
  const PageLaw* law = nullptr;
  ExprId at{};
  int order = 0;  // of the derivative
};

/// Those on the unknown, in the order of the laws.
[[nodiscard]] std::vector<ValueCondition> conditions_on(const ExprTree& tree, const Names& names,
                                                        const Laws& laws, SymbolId unknown);

/// An equation for an unknown function of one variable.
struct DifferentialEquation {
  Equation equation;
  SymbolId unknown{};
  Variable by = {};
  std::uint8_t axis = 0;  // by a place: which
  int order = 0;
};

/// Do they leave one solution at most? All derivatives below the order at one place do, where the equation is
/// a polynomial in the unknown and the highest derivative has a constant factor (Picard and Lindelöf); where
/// only the highest derivative has the unknown, two conditions at two places do, unless both are on slopes.
[[nodiscard]] bool leave_one_solution(const ExprTree& tree, const Names& names,
                                      const DifferentialEquation& equation,
                                      const std::vector<ValueCondition>& conditions);

}  // namespace rigor
