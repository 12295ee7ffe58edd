// SPDX-License-Identifier: GPL-3.0-or-later
// Values of functions that a sample takes as any numbers.
#pragma once

#include "elaborate/name/names.h"
#include "expr/statement/statement.h"

namespace rigor {

/// Does the question have a value of a function of which more is not known? `f(2x)` and `f(x + x)` are two
/// symbols to us; `\omega(k + q)` of `\omega(k) = ck` can be a product.
[[nodiscard]] bool speaks_of_values(const Question& question, const Names& names);

}  // namespace rigor
