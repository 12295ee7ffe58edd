// SPDX-License-Identifier: GPL-3.0-or-later
// An equation between scalars that fails for some values is a wrong identity, or says which values are meant:
// the curve `(x^2 + y^2)^2 = x^2 - y^2`, the condition `\cos ka\cosh\kappa a = 1`, the balance `xy = x + y`.
// An author who means an identity writes one that is near a true one, or announces it.
#pragma once

#include <string_view>

#include "expr/statement/statement.h"

namespace rigor {

/// Numbers on both sides, made of scalars and lengths at one time and place: no index, no derivative.
[[nodiscard]] bool may_be_an_equation_of_letters(const ExprTree& tree, const Equation& equation);

/// Of such an equation: it is about vectors, or equates a product of sums to a sum of terms up to its degree,
/// `(u - v)^2 = u^2 - v^2`, or a fraction to a sum of fractions, `1/(a + b) = 1/a + 1/b`.
[[nodiscard]] bool reads_as_identity(const ExprTree& tree, const Equation& equation);

/// "the identity", "expand", "hence", "for all": the row is meant for all values. Of the words since the last
/// display.
[[nodiscard]] bool announces_an_identity(std::string_view lead);

/// "the curve", "conservation of", "Kirchhoff's rule": the row says which values are meant.
[[nodiscard]] bool names_an_equation_of_letters(std::string_view lead);

/// "Solve", "the roots of": the same, and more clearly so than a slip of the pen is one.
[[nodiscard]] bool asks_for_values(std::string_view lead);

}  // namespace rigor
