// SPDX-License-Identifier: GPL-3.0-or-later
// Nodes of expressions that rules make: nothing superfluous is written, no factor 1, no sum of one term.
#pragma once

#include <cstdint>
#include <vector>

#include "base/small_rational.h"
#include "expr/tree/tree.h"

namespace rigor {

/// The node with other children and slots; `id` tells the table of a table.
[[nodiscard]] ExprId with_children(ExprTree& tree, ExprId id, const ExprNode& node,
                                   const std::vector<ExprId>& children, const std::vector<Slot>& slots);

[[nodiscard]] ExprId number_node(ExprTree& tree, std::int64_t value);
/// 3/2 as a quotient, -1 as a negated 1.
[[nodiscard]] ExprId rational_node(ExprTree& tree, SmallRational value);
/// No factors: 1. Numbers 1 are left out.
[[nodiscard]] ExprId product_node(ExprTree& tree, const std::vector<ExprId>& factors);
/// No terms: the 0 of the rank.
[[nodiscard]] ExprId sum_node(ExprTree& tree, const std::vector<ExprId>& terms, int rank = 0);
[[nodiscard]] ExprId negated_node(ExprTree& tree, ExprId id);
/// The first power is the base itself.
[[nodiscard]] ExprId power_node(ExprTree& tree, ExprId base, int exponent);
[[nodiscard]] ExprId quotient_node(ExprTree& tree, ExprId dividend, ExprId divisor);
[[nodiscard]] ExprId dot_node(ExprTree& tree, ExprId a, ExprId b);
[[nodiscard]] ExprId cross_node(ExprTree& tree, ExprId a, ExprId b);
[[nodiscard]] ExprId index_sum_node(ExprTree& tree, IndexId index, ExprId body);
[[nodiscard]] ExprId particle_sum_node(ExprTree& tree, ParticleId particle, ExprId body);
[[nodiscard]] ExprId symbol_node(ExprTree& tree, SymbolId symbol, ParticleId particle,
                                 const std::vector<Slot>& slots);

}  // namespace rigor
