// SPDX-License-Identifier: GPL-3.0-or-later
// Which monomials are the same but for the names of what is summed over, the order of factors, and the
// symmetries of tensors, δ and ε.
#pragma once

#include <string>

#include "derive/index_polynomial.h"

namespace rigor {

/// Equal texts mean equal polynomials. The other way round it holds where at most `most_renamings` names of
/// summed letters had to be tried, and for what is not equal for deeper reasons (such as four indices that
/// cannot all be different).
[[nodiscard]] std::string canonical_text(const SymbolTable& symbols, const IndexPolynomial& polynomial);

/// The same without adding up equal terms: texts are equal where each term of one polynomial is a term of the
/// other.
[[nodiscard]] std::string text_of_terms(const SymbolTable& symbols, const IndexPolynomial& polynomial);

inline constexpr std::size_t most_renamings = 720;

/// Powers of equal factors joined, √x √x = x, a_i a_i / |a|² = 1, numbers taken out of roots and
/// denominators. False where nothing changed.
bool join_powers(ExprTree& tree, IndexPolynomial& polynomial);

/// Equal terms added up, those that vanish by a symmetry dropped, powers of equal factors joined, √x √x = x,
/// a_i a_i / |a|² = 1. The first of equal terms stays as it was written.
[[nodiscard]] IndexPolynomial collected(ExprTree& tree, const IndexPolynomial& polynomial);

}  // namespace rigor
