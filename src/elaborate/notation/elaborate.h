// SPDX-License-Identifier: GPL-3.0-or-later
// From what was written to what is meant, one part at a time: names, kinds, index sums, vector products.
#pragma once

#include "elaborate/reading/reading.h"

namespace rigor {

/// Reads a side of the statement, or a part of one. What has a mistake gives nothing and a diagnostic for
/// each mistake found. Recursion is bounded by the parser's `max_nesting`, that of derivatives by their
/// budget.
[[nodiscard]] MaybeTyped elaborate(Reading& reading, SyntaxId id, const Around& around = {});

/// The symbol of an integral or a sum, always the same one.
SymbolId symbol_of_integral(ExprTree& tree, const Integral& integral, Span span);
/// The same of the average of this. `complex`: nothing shows that it is a real number.
SymbolId symbol_of_average(ExprTree& tree, ExprId inside, bool complex, Span span);
/// If the average is a real number: the operators that are taken to be observables for that, since the page
/// writes no adjoint of them. Nothing where it may be complex.
[[nodiscard]] std::optional<std::vector<SymbolId>> observables_with_real_average(const Names& names,
                                                                                 const ExprTree& tree,
                                                                                 ExprId inside);

}  // namespace rigor
