// SPDX-License-Identifier: GPL-3.0-or-later
// Products of representations that are written with the signs of numbers: `\tfrac12\times\tfrac12 = 1 + 0`
// says that two spins of one half make a triplet and a singlet.
#pragma once

#include "latex/token/syntax.h"

namespace rigor {

/// Is one side a product of spins, and the other one the sum of those that they make: for j and k all of
/// |j - k|, |j - k| + 1, …, j + k? At least two of them.
[[nodiscard]] bool may_combine_spins(const SyntaxTree& syntax, SyntaxId left, SyntaxId right);

}  // namespace rigor
