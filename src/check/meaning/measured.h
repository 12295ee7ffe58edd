// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "expr/tree/tree.h"

namespace rigor {

/// `12.5`, `0.3\,\mathrm m`: numbers and units of measure alone.
[[nodiscard]] inline bool is_measured(const ExprTree& tree, ExprId side) {
  return std::ranges::all_of(symbols_in(tree, side),
                             [&](SymbolId each) { return tree.symbols[each].unit_of_measure.has_value(); });
}

}  // namespace rigor
