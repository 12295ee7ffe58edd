// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict of one row, in two steps: `ask` gets the answer of the exact side, and `settle` weighs it
// against the words around the row. Between the two, the walk looks whether the answer shows that a name has
// another meaning.
#pragma once

#include <optional>

#include "check/place/place.h"

namespace rigor {

[[nodiscard]] inline bool is_open(const Judgement& judgement) {
  return judgement.verdict == Verdict::refuted || judgement.verdict == Verdict::undecided ||
         judgement.verdict == Verdict::not_understood;
}

/// Nothing: the step has its verdict, by another reading or as a condition.
[[nodiscard]] std::optional<Judgement> ask(RowPlace& place, const StepReading& row, const Claim& claim,
                                           Step& step);
void settle(RowPlace& place, const StepReading& row, const Claim& claim, Judgement judgement, Step& step);

void accept(Judgement judgement, Step& step);

}  // namespace rigor
