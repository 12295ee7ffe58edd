// SPDX-License-Identifier: GPL-3.0-or-later
// A look before a proof is searched for: does the claim fail where its assumptions hold? Nearly every set of
// laws that is tried proves nothing, and to find that out by algebra takes a hundred times as long.
#pragma once

#include "algebra/engine/budget.h"
#include "expr/statement/statement.h"

namespace rigor {

/// True only where the sides of an equation clearly differ at several points at which all assumptions hold,
/// so that a proof would be a surprise. It refutes nothing. Points are real numbers of double precision,
/// drawn from a fixed sequence and moved onto the assumptions by Newton's method with the smallest steps;
/// thresholds are orders of magnitude apart, so that rounding hardly decides. False where that does not
/// work: of operators and rotations, of more than 128 numbers, and where no point is found.
/// The budget may be none.
[[nodiscard]] bool fails_at_rough_points(const Question& question, Budget* budget);

}  // namespace rigor
