// SPDX-License-Identifier: GPL-3.0-or-later
// `(\partial T/\partial V)_S = -(\partial p/\partial S)_V`: derivatives with a letter held are those of
// functions on a surface of states. Two letters, u and v, are its coordinates; every other letter that
// changes is a function of them. So
//
//   (∂X/∂Y)_Z = (X_u Z_v − X_v Z_u) / (Y_u Z_v − Y_v Z_u),
//
// dU = T dS − p dV says so of both derivatives, and implies T_v S_u − T_u S_v = p_v V_u − p_u V_v, since
// mixed second derivatives are equal. What is left is an identity between derivatives by u and v, which the
// exact side decides. A system with more degrees of freedom has many such surfaces; what is proved holds on
// each.
#pragma once

#include <optional>

#include "check/law/from_set.h"

namespace rigor {

/// Does the equation have differentials, or derivatives that hold a letter by name?
[[nodiscard]] bool speaks_of_states(const ExprTree& tree, const Equation& equation);

/// Does it lead to derivatives that hold a letter by name, definitions unfolded?
[[nodiscard]] bool holds_letters(const ExprTree& tree, const NameScope& scope, const Equation& equation);

/// Proved, with `uses`, from the laws and the definitions that it leads to; nothing if no proof was found.
/// Relations of a case, and those between two letters only (an isotherm, an adiabat), are not used. A sample
/// must meet what was used on which nothing of it vanishes.
[[nodiscard]] std::optional<Judgement> prove_of_states(const RowUnderLaws& row, const Laws& set);

}  // namespace rigor
