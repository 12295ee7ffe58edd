// SPDX-License-Identifier: GPL-3.0-or-later
// Which laws of the page bear on a row, and which of them are tried together.
#pragma once

#include <set>
#include <vector>

#include "check/law/page_law.h"
#include "elaborate/name/names.h"

namespace rigor {

/// Those that share a letter with the row, then those that share one with these. Within each round those come
/// first that bring in the fewest other letters, and of such the nearest. `available`: in the order of the
/// notes.
[[nodiscard]] Laws laws_that_bear(const ExprTree& tree, const NameScope& scope, const Equation& row,
                                  const Laws& available);

/// None (the row may only lack that something is constant), each of the nearest alone, and more and more
/// together. Most rows follow from one or two laws near them.
/// Two laws with one left side may be those of two systems, "Particle A obeys `\dot x = ax`, particle B obeys
/// `\dot x = bx`". So they are taken together only if no words stand between them.
[[nodiscard]] std::vector<Laws> sets_of(const ExprTree& tree, const Laws& bearing);

/// For a row with derivatives that hold letters by name: it needs a relation between differentials and an
/// equation of state, which stand near it. What follows from these only makes the search longer.
[[nodiscard]] std::vector<Laws> sets_of_states(const Laws& bearing);

}  // namespace rigor
