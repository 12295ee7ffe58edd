// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "elaborate/name/names.h"

namespace rigor {

/// `x(0)`, `V(r_0)`: the value of a function at its argument, which is a symbol under this name. What it is
/// follows from the function, so that a row about it defines nothing.
[[nodiscard]] inline bool is_function_value(const Names& names, const ExprTree& tree, SymbolId symbol) {
  return names.symbols.function_values->contains(base_of(tree.symbols, symbol));
}

}  // namespace rigor
