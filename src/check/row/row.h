// SPDX-License-Identifier: GPL-3.0-or-later
// The verdict of one row, in two steps: what the exact side answers, and what the words around the row leave
// of that. Between them the walk looks whether the answer gives a name another meaning.
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
