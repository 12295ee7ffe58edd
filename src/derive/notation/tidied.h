// SPDX-License-Identifier: GPL-3.0-or-later
// An expression without what no lecturer writes.
#pragma once

#include "expr/tree/tree.h"

namespace rigor {

/// The same value: a product in a product is one product, sums over components are in front of products, a
/// number stands first, no factor is 1, δ and ε with numbers are numbers, and what is 0 by that is no term.
/// Cost: linear, but for sums in products, which are copied.
[[nodiscard]] ExprId tidied(ExprTree& tree, ExprId root);

}  // namespace rigor
