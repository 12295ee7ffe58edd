// SPDX-License-Identifier: GPL-3.0-or-later
// An equation solved for a letter that stands in it once: p = nRT/V of `pV = nRT`.
#pragma once

#include <optional>
#include <vector>

#include "expr/tree/tree.h"

namespace rigor {

struct IsolatedLetter {
  ExprId value{};
  std::vector<ExprId> divided_by = {};  // not 0, if the value is to follow
};

/// By sums, products, quotients, logarithms and exponentials alone, of numbers: none of these leaves a
/// choice. Nothing where the letter stands more than once, or below something else.
[[nodiscard]] std::optional<IsolatedLetter> isolated_letter(ExprTree& tree, ExprId left, ExprId right,
                                                            SymbolId letter);

}  // namespace rigor
