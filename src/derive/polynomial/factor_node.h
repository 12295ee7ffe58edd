// SPDX-License-Identifier: GPL-3.0-or-later
// One factor of a monomial as an expression.
#pragma once

#include "derive/polynomial/index_polynomial.h"

namespace rigor {

/// To the size of its exponent: a factor 1/r³ gives r³. The root of a_i a_i is the length of a.
[[nodiscard]] ExprId factor_node(ExprTree& tree, const IndexFactor& factor);

/// a of √(a_i a_i), where a is a symbol.
[[nodiscard]] std::optional<ExprId> vector_of_length(ExprTree& tree, const IndexFactor& root);

}  // namespace rigor
