// SPDX-License-Identifier: GPL-3.0-or-later
// Translates samples of the exact side into the notes' own symbols, and back.
#pragma once

#include "base/result.h"
#include "check/question/question.h"
#include "check/step/report.h"

namespace rigor {

[[nodiscard]] Counterexample describe(const Prepared& prepared, const Sample& sample);

/// The sample that a description gives for a question: its symbols are found by name, rank and particle;
/// symbols that share all three are taken in their order. An error says what does not fit.
[[nodiscard]] Result<Sample> sample_of(const Question& question, const Counterexample& example);

}  // namespace rigor
