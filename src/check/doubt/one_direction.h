// SPDX-License-Identifier: GPL-3.0-or-later
// `F = qvB` next to `\mathbf F = q\mathbf v\times\mathbf B`: plain letters of vectors are their lengths, or
// their components along one direction that the figure shows. `a_1b_1 + a_2b_2`: in space, or in the plane.
#pragma once

#include <optional>
#include <vector>

#include "elaborate/evidence/evidence.h"
#include "expr/statement/statement.h"

namespace rigor {

/// The vectors whose lengths a side has as plain letters, if it has no vectors but those letters and one of
/// them is in an odd power. Bars say that lengths are meant, and a derivative by a coordinate says that all
/// directions are. Nothing else is returned. Cost: linear in the equation.
[[nodiscard]] std::vector<SymbolId> lengths_or_components(const ExprTree& tree, const Equation& equation);

/// The equation with a number of its own for each vector, where nothing of vectors but lengths is in it: what
/// fails for all numbers does not wait for directions.
[[nodiscard]] std::optional<Equation> with_numbers_for_lengths(ExprTree& tree, const Equation& equation);

/// Does the equation write components along the first two axes, where nothing in the section is along the
/// third or has three components?
[[nodiscard]] bool may_be_in_the_plane(const ExprTree& tree, const Evidence& evidence,
                                       const Equation& equation);

}  // namespace rigor
