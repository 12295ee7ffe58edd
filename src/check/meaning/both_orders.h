// SPDX-License-Identifier: GPL-3.0-or-later
// What a row itself shows of order: nobody writes `ab = ba` of numbers, nor `e^Ae^B = e^{A+B}` in capitals.
#pragma once

#include <set>

#include "elaborate/name/names.h"
#include "expr/statement/statement.h"
#include "expr/tree/tree.h"

namespace rigor {

/// The scalars that are written side by side in both orders, `H\psi = \psi H`, `aba = a^2b`, `S_xS_y =
/// S_yS_x`, and the capitals of exponents where the row has two. Not those that a directive declares, or that
/// the section shows to be numbers, nor components of different vectors. Cost: quadratic in the factors of a
/// product.
[[nodiscard]] std::set<SymbolId> symbols_in_both_orders(const ExprTree& tree, const Names& names,
                                                        const Equation& claim);

/// The single capitals of a claim that is an identity of numbers, but none in the order of their factors:
/// `(AB)^2 = A^2B^2`, `(A + B)(A - B) = A^2 - B^2`. Not those that a directive declares, a definition makes
/// of numbers, or the section shows to be numbers. Cost: that of `equal_with_units`.
[[nodiscard]] std::set<SymbolId> capitals_that_must_commute(const Question& question, const Names& names);

}  // namespace rigor
