// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers by which the notes divide: what is written of them holds where they are not 0.
#pragma once

#include <vector>

#include "elaborate/name/names.h"
#include "expr/statement/statement.h"

namespace rigor {

/// The sample's scalars that are a factor of a divisor in a definition or assumption in force, in the order
/// of the sample; empty unless one of them is 0 there.
[[nodiscard]] std::vector<SymbolId> divisors_of_sample(const ExprTree& tree, const Names& names,
                                                       const Sample& sample);

}  // namespace rigor
