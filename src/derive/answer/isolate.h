// SPDX-License-Identifier: GPL-3.0-or-later
// What a hole must be if an equation holds: the operations around it are undone, one after the other.
#pragma once

#include <optional>
#include <string>

#include "expr/statement/statement.h"

namespace rigor {

/// The hole's value as the equation gives it, not simplified; or why there is none. It need not fit: of
/// several components, and after a root, only the product with what comes before the hole is compared.
struct Isolation {
  std::optional<ExprId> value = {};
  bool squared = false;  // both sides were squared: the value fits only where their signs agree
  std::string obstacle = {};
};

/// The hole is on the right side of the claim. Undone are sums, products, quotients and a root; a product
/// with a vector, or with components that are not the hole's own, by multiplying with it once more: x from a
/// = x b is (a·b)/(b·b). A number under sums is found from the values at 0 and 1. Cost: linear in
/// the sides.
[[nodiscard]] Isolation isolated(ExprTree& tree, const Equation& claim, SymbolId hole);

/// How often a symbol is below a node, at most 2.
[[nodiscard]] int occurrences_of(const ExprTree& tree, ExprId root, SymbolId symbol);

/// The expression with the symbol, wherever it stands and at whatever slots, replaced.
[[nodiscard]] ExprId with_symbol_as(ExprTree& tree, ExprId root, SymbolId symbol, ExprId value);

}  // namespace rigor
