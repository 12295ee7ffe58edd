// SPDX-License-Identifier: GPL-3.0-or-later
// The symbol of an average, `\langle x^2\rangle`, which keeps what is averaged.
#pragma once

#include <optional>
#include <vector>

#include "elaborate/name/names.h"

namespace rigor {

/// Always the same one of the same expression. `complex`: nothing shows that it is a real number.
SymbolId symbol_of_average(ExprTree& tree, ExprId inside, bool complex, Span span);

/// If the average is a real number: the operators that are taken to be observables for that, since the page
/// writes no adjoint of them. Nothing where it may be complex.
[[nodiscard]] std::optional<std::vector<SymbolId>> observables_with_real_average(const Names& names,
                                                                                 const ExprTree& tree,
                                                                                 ExprId inside);

}  // namespace rigor
