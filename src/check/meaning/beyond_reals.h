// SPDX-License-Identifier: GPL-3.0-or-later
// What is proved of real numbers, and need not hold where letters are complex, or bars are a determinant.
#pragma once

#include <set>

#include "elaborate/name/names.h"
#include "expr/statement/statement.h"

namespace rigor {

/// The scalars of the question that can be complex: the usual letters z, w, ψ and φ, what is conjugated in
/// the section, and all letters where it speaks of complex numbers or writes i. Not those that a directive
/// declares, and those that the section shows to be real.
[[nodiscard]] std::set<SymbolId> complex_symbols(const Question& question, const Names& names);

/// Does the claim hold at complex values of these as well? Where no modulus, root or order of them occurs,
/// what holds for real numbers holds for complex ones. Elsewhere it is tried in floating point at a few fixed
/// values, and what cannot be tried counts as no. So it withholds proofs, and makes none.
[[nodiscard]] bool holds_for_complex(const Question& question, const std::set<SymbolId>& symbols);

/// The capitals in bars that make a difference if the bars are a determinant: `|2A| = 2|A|`, `|A|^2 = A^2`,
/// and not `|AB| = |A||B|`. Not those that a directive declares, or that the section shows to be numbers.
[[nodiscard]] std::set<SymbolId> symbols_of_determinants(const Question& question, const Names& names);

}  // namespace rigor
