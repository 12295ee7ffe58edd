// SPDX-License-Identifier: GPL-3.0-or-later
// Does an equation say the same along any axes? Then it keeps its form where the axes turn: what is true of
// the components at one moment is true of them at all times.
#pragma once

#include <vector>

#include "elaborate/name/names.h"
#include "expr/tree/tree.h"

namespace rigor {

/// No axis is named (`A_1`, `\mathbf e_3`, a tuple), each letter of `free` stands once in every term, and the
/// others are summed over in pairs. Principal values I_i are numbers that belong to axes. Sound: what is not
/// recognised is not covariant. Recursion: as deep as the tree.
[[nodiscard]] bool is_covariant(const ExprTree& tree, const Names& names, ExprId root,
                                const std::vector<IndexId>& free);

}  // namespace rigor
