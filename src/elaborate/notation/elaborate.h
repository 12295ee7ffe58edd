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

}  // namespace rigor
