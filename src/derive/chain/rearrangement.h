// SPDX-License-Identifier: GPL-3.0-or-later
// What was done between two equal expressions if only terms and factors were moved.
#pragma once

#include "derive/chain/rule.h"
#include "expr/tree/tree.h"

namespace rigor {

/// The first thing that tells them apart: quotients, brackets, terms, powers, signs of products, names.
[[nodiscard]] RuleKind rearrangement_of(const ExprTree& tree, ExprId before, ExprId after);

/// `rules` with what is only `rearranged` in words: what it was, or nothing where another rule says it all.
[[nodiscard]] Rules described(const ExprTree& tree, Rules rules, ExprId before, ExprId after);

}  // namespace rigor
