// SPDX-License-Identifier: GPL-3.0-or-later
// What the trace of a proof says, as a value that no type of GiNaC is in: equations, cofactors, and the
// letters that occur in them. Nothing of it counts on a budget, and it is bounded by itself: a proof that is
// found is the same whether it is written down or not.
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
