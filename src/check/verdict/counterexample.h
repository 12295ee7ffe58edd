// SPDX-License-Identifier: GPL-3.0-or-later
// Samples of the exact side in the notes' own symbols, and back.
#pragma once

#include "base/result.h"
#include "check/question/question.h"
#include "check/step/report.h"

namespace rigor {

[[nodiscard]] Counterexample describe(const Prepared& prepared, const Sample& sample);

/// The sample that a description gives for a question: its symbols are found by name, rank and particle,
/// those that are called alike in their order. An error says what does not fit.
[[nodiscard]] Result<Sample> sample_of(const Question& question, const Counterexample& example);

}  // namespace rigor
