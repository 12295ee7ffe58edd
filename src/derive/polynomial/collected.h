// SPDX-License-Identifier: GPL-3.0-or-later
// Sums of monomials made shorter: equal terms are one, and terms that vanish are dropped.
#pragma once

#include <string>

#include "derive/polynomial/index_polynomial.h"

namespace rigor {

/// Texts are equal where each term of one polynomial is a term of the other.
[[nodiscard]] std::string text_of_terms(const SymbolTable& symbols, const IndexPolynomial& polynomial);

/// Powers of equal factors joined, √x √x = x, a_i a_i / |a|² = 1, numbers taken out of roots and
/// denominators. False where nothing changed.
bool join_powers(ExprTree& tree, IndexPolynomial& polynomial);

/// Terms that are their own negative for a symmetry, such as ε_ijk A_j A_k, are dropped. False where there is
/// none.
bool drop_antisymmetric(const SymbolTable& symbols, IndexPolynomial& polynomial);

/// Equal terms added up, those that vanish by a symmetry dropped, powers of equal factors joined, √x √x = x,
/// a_i a_i / |a|² = 1. The first of equal terms stays as it was written.
[[nodiscard]] IndexPolynomial collected(ExprTree& tree, const IndexPolynomial& polynomial);

}  // namespace rigor
