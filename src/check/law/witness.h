// SPDX-License-Identifier: GPL-3.0-or-later
// A set of laws that is only met where something vanishes proves what nobody means: see `from_laws.h`.
#pragma once

#include <vector>

#include "check/law/from_laws.h"

namespace rigor {

/// Was a sample found that meets the laws, with what else holds, on which no letter, term or side of the
/// claim or of the laws is 0? A side that is set equal to a written 0 may vanish, and so may a letter alone,
/// and a term that vanishes by one such law for itself.
/// Letters of particles, tensors, and terms with free indices are not looked at. `names` assumes the laws.
[[nodiscard]] bool is_met_without_zeros(ExprTree& tree, const Names& names, const Equation& claim,
                                        const std::vector<const PageLaw*>& laws, DecisionCache* cache);

}  // namespace rigor
