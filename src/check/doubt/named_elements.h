// SPDX-License-Identifier: GPL-3.0-or-later
// Elements of a group or an algebra, written as numbers or with indices: `(12)(123)(12) = (132)` multiplies
// cycles, and `E_{ij}E_{kl} = \delta_{jk}E_{il}` matrices that are numbered by two indices.
#pragma once

#include <string_view>

#include "expr/statement/statement.h"

namespace rigor {

/// Can both sides be products of cycles, or one of them a letter or 1? A cycle has at least two digits in
/// brackets, each of them once, and no 0.
[[nodiscard]] bool may_be_cycles(std::string_view left, std::string_view right);

/// Is one side a product of two of the elements that a letter numbers by its indices, and the other one a sum
/// of single ones? No components of a tensor obey that for all values.
[[nodiscard]] bool may_multiply_elements(ExprTree& tree, const Equation& equation);

}  // namespace rigor
