// SPDX-License-Identifier: GPL-3.0-or-later
// Which monomials are the same but for the names of what is summed over, the order of factors, and the
// symmetries of tensors, δ and ε.
#pragma once

#include <string>

#include "derive/polynomial/index_polynomial.h"

namespace rigor {

/// A monomial without its coefficient.
struct CanonicalMonomial {
  std::string text;
  int sign = 1;  // 0: vanishes by a symmetry
};

[[nodiscard]] CanonicalMonomial canonical_monomial(const SymbolTable& symbols, const IndexMonomial& term);

/// Equal texts mean equal polynomials. Equal polynomials have equal texts where at most `most_renamings`
/// names of summed letters had to be tried, unless they are equal for deeper reasons (such as that four
/// indices cannot all be different).
[[nodiscard]] std::string canonical_text(const SymbolTable& symbols, const IndexPolynomial& polynomial);

inline constexpr std::size_t most_renamings = 720;

}  // namespace rigor
