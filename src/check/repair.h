// SPDX-License-Identifier: GPL-3.0-or-later
// What a wrong step may have been meant to say: the statements nearest to it that can be proved.
#pragma once

#include <vector>

#include "check/repair_candidates.h"
#include "check/report.h"
#include "elaborate/names.h"
#include "expr/tree.h"

namespace rigor {

inline constexpr std::size_t most_repairs = 3;

/// At most three, the nearest first; none where no slip of the pen makes it true. Of a refuted step, or of
/// one whose indices or ranks do not fit. Method: each side is rewritten; terms are compared by the number
/// that the difference of the sides is of each (`left − right = c · term`); what holds on exact samples is
/// read anew with its whole chain, and proved. Trivial statements (a = a, 0 = 0) are left out. The names are
/// as before afterwards. Cost: a few milliseconds; every part of the search has a budget.
[[nodiscard]] std::vector<Repair> nearest_true_statements(ExprTree& tree, Names& names,
                                                          const WrongStep& wrong);

}  // namespace rigor
