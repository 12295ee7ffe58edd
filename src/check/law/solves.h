// SPDX-License-Identifier: GPL-3.0-or-later
// `x = a\cos\omega t + b\sin\omega t` follows from no equation of motion, since other motions obey it, too.
// It solves it.
#pragma once

#include <optional>

#include "check/law/from_set.h"
#include "check/law/value_conditions.h"

namespace rigor {

/// What a row `x = …`, without x on the right, may solve.
struct SolvedEquation {
  DifferentialEquation of;
  const PageLaw* law = nullptr;
  Laws others = {};         // that may be needed for it
  bool particular = false;  // the row is one of many solutions
};

/// x of x_p, "a particular solution"; nothing of other letters.
[[nodiscard]] std::optional<SymbolId> letter_of_particular_solution(const Names& names, SymbolId letter);

/// The nearest law with a derivative of x.
[[nodiscard]] std::optional<SolvedEquation> solved_equation(const RowUnderLaws& row, const Laws& bearing);

/// The equation with a function and its derivatives put in; nothing where they cannot be.
[[nodiscard]] std::optional<Equation> put_in(ExprTree& tree, const Names& names,
                                             const DifferentialEquation& equation, ExprId function);

/// Does the row solve the nearest law with a derivative of x? Put in, the law holds, and the row has as many
/// independent free constants as the order of the law says, two at most; or it has none, and meets the
/// initial or boundary conditions among `available`, which leave one solution. So it is what the law leaves
/// open. `uses` names the law and what else is needed for that. Of x_p it is enough that it solves the law of
/// x.
[[nodiscard]] std::optional<Judgement> solves(const RowUnderLaws& row, const Laws& bearing,
                                              const Laws& available);

// --- trial.cpp: `x = A\cos(\omega t - \delta)` in `\ddot x + 2\gamma\dot x + \omega_0^2x = f\cos\omega t`:
// what a trial function asks of its constants.

/// Does the row follow since the nearest law with derivatives of an unknown holds, with what another law says
/// of the unknown put in, for all values of its variables? It is asked for where they are 0, for the equation
/// and its derivatives up to the third, the second for two variables. That the trial function is not 0 and
/// changes with its variables is a convention, which `uses` names.
[[nodiscard]] std::optional<Judgement> follows_from_trial(const RowUnderLaws& row, const Laws& bearing);

}  // namespace rigor
