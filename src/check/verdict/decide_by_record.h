// SPDX-License-Identifier: GPL-3.0-or-later
// Confirms a refutation by its recorded sample, without the code that searches for samples.
#pragma once

#include "check/question/question.h"
#include "check/step/recorded.h"

namespace rigor {

/// The step's question answered by the recorded sample: refuted if all assumptions hold on it, if the sides
/// have the recorded values, and if they differ; else undecided, and `fault` says why. Nothing is searched
/// for. Swapped: the claim has the sides the other way round.
[[nodiscard]] Decision decide_by_record(const Prepared& prepared, bool swapped, RecordedStep& recorded);

/// Does the sample speak of first-order parts, `\delta x`?
[[nodiscard]] bool is_of_first_order(const Counterexample& example);

}  // namespace rigor
