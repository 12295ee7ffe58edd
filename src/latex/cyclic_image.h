// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "latex/syntax.h"

namespace rigor {

/// The expression with 1 → 2 → 3 → 1 and x → y → z → x in all its subscripts: what "and cyclic permutations"
/// says, too. Cost: linear in the expression.
[[nodiscard]] SyntaxId cyclic_image(SyntaxTree& syntax, SyntaxId root);

}  // namespace rigor
