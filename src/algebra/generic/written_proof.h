// SPDX-License-Identifier: GPL-3.0-or-later
// The trace of a proof as a value without any type of GiNaC: equations, cofactors, and the letters that occur
// in them. Its work is bounded by limits of its own and counts on no budget, so that what is proved does not
// depend on whether it is written down.
#pragma once

#include <span>
#include <vector>

#include "algebra/generic/cofactors.h"
#include "expr/statement/proof.h"

namespace rigor {

/// Puts the steps into a proof, one for each vanishing, with the letters, equations, factors and solutions
/// that they name. `axes`: the component that each vanishing is of.
void write_steps(Proof& proof, const Scope& scope, GenericDomain& domain, const ConstraintsTrace& trace,
                 std::span<const std::vector<std::uint8_t>> axes);

}  // namespace rigor
