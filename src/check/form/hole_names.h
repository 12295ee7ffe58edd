// SPDX-License-Identifier: GPL-3.0-or-later
// Which names in scope fill a hole: each is put in and proved or refuted.
#pragma once

#include "check/form/holes.h"
#include "check/verdict/judge.h"

namespace rigor {

/// Fills `names` and `takes_anything` of a reading whose claim, symbol and node are set. Names that are in
/// the claim itself are left out. Tried are at most 200 candidates: names that are defined or that equations
/// spoke of, with the hole's letters in any order, their squares and the same with a minus sign.
void try_names(ExprTree& tree, const Names& names, const Claim& claim, HoleReading& reading);

}  // namespace rigor
