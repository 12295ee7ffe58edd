// SPDX-License-Identifier: GPL-3.0-or-later
// Equality where some symbols need not commute.
#pragma once

#include <set>

#include "elaborate/name/names.h"
#include "expr/statement/statement.h"
#include "expr/tree/tree.h"

namespace rigor {

/// Are both sides of the claim equal for matrices and operators in the place of `ordered`, by the rules of
/// sums, products, powers and multiples alone? It is assumed that they are equal for numbers. The sides
/// become sums of words with a factor of commuting symbols; with x(y + z) = xy + xz and (y + z)x = yx + zx
/// nothing else is used. One symbol that stands alone in `ordered` commutes with itself, and with what is
/// made of it, where no assumption is about it: `M^2 = 0` gives M = 0 for numbers only. False: not known.
/// Cost: grows with the words, which are bounded.
[[nodiscard]] bool equal_in_order(const Question& question, const std::set<SymbolId>& ordered);

/// The same without the help of numbers, with 1 in the place of `units`, which are among `ordered`.
[[nodiscard]] bool equal_with_units(const ExprTree& tree, ExprId left, ExprId right,
                                    const std::set<SymbolId>& ordered, const std::set<SymbolId>& units);

/// Does no term of the claim, definitions unfolded, have two factors of `ordered`, and no assumption one?
/// Then there is no order to keep, and what holds for numbers holds for matrices and operators. Cost: linear
/// in the tree for each use of a definition, which are bounded.
[[nodiscard]] bool is_linear_in(const Question& question, const std::set<SymbolId>& ordered);

/// The symbols of the claim, and of what it may be decided with, that the section shows to be matrices or
/// operators and no directive declares to be anything else.
[[nodiscard]] std::set<SymbolId> ordered_symbols(const ExprTree& tree, const Names& names,
                                                 const Question& question);

/// Those among them that the words call the unit matrix.
[[nodiscard]] std::set<SymbolId> unit_matrices(const Names& names, const Question& question,
                                               const std::set<SymbolId>& ordered);

}  // namespace rigor
