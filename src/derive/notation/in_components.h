// SPDX-License-Identifier: GPL-3.0-or-later
// Direct notation written in components, nothing multiplied out: (A×B)_i is ε_ijk A_j B_k, |a|² is a_i a_i.
#pragma once

#include <set>
#include <span>
#include <string>

#include "expr/tree/tree.h"

namespace rigor {

/// What was written out, in words: `definition of ×`.
using WrittenOut = std::set<std::string>;

/// The component at as many slots as the expression has rank. Odd powers of lengths stay as they are.
[[nodiscard]] ExprId in_components(ExprTree& tree, ExprId id, std::span<const Slot> slots, WrittenOut& what);

}  // namespace rigor
