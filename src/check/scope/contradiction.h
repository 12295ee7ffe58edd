// SPDX-License-Identifier: GPL-3.0-or-later
// Assumptions that cannot hold together: at one moment, or at all times, where one speaks of a quantity and
// another of its rate. `u = 3` and `\dot u = 1` have samples for each moment, and none for all.
#pragma once

#include <optional>

#include "elaborate/name/names.h"
#include "expr/statement/statement.h"

namespace rigor {

class DecisionCache;

/// Is 0 = 1 proved from the last assumption, those that bear on it, and their derivatives? False where
/// nothing is found. Cost: an attempt at a proof, where another assumption shares a letter or a time or place
/// is spoken of.
[[nodiscard]] bool last_assumption_contradicts(ExprTree& tree, const Names& names);

/// The same if the definition were an assumption; it is not kept.
[[nodiscard]] bool definition_contradicts(ExprTree& tree, const Names& names, const Definition& definition);

/// The letters of the last assumption that are declared constant; they no longer count as constant then.
/// Gives the directives that said so.
[[nodiscard]] Directives withdraw_constants_of_last(const ExprTree& tree, Names& names);

/// What is declared small is of first order. `E = v^2`, where nothing else says that v is small, makes E the
/// square of what is then of order 1/2: the small letters of the equation to which that happens.
[[nodiscard]] std::optional<SymbolId> small_of_other_order(ExprTree& tree, const Names& names,
                                                           const Equation& equation, DecisionCache* cache);

}  // namespace rigor
