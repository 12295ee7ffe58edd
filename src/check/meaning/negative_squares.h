// SPDX-License-Identifier: GPL-3.0-or-later
// Names that are defined by their square, `(\Omega)^2 = k`, on a sample on which that square is negative.
#pragma once

#include <vector>

#include "elaborate/name/names.h"
#include "expr/statement/statement.h"

namespace rigor {

struct NegativeSquare {
  SymbolId name{};
  Equation not_negative;  // 0 ≤ k
  Equation negative;      // k < 0
};

/// The definitions in force whose square the sample makes negative. Cost: one evaluation each.
[[nodiscard]] std::vector<NegativeSquare> negative_squares_of_sample(ExprTree& tree, const Names& names,
                                                                     const Question& question,
                                                                     const Sample& sample);

}  // namespace rigor
