// SPDX-License-Identifier: GPL-3.0-or-later
// Refutations about averages. Numbers that are put in for `\langle x\rangle` and `\langle x^2\rangle` need be
// the averages of nothing, so that such a sample counts only if some distribution has them: that of two
// outcomes with equal weights, which is looked for.
//
// A row that relates different averages says something of the distribution, as `\langle x^4\rangle =
// 3\langle x^2\rangle^2` does. One whose sides have the same averages, with other coefficients, is a slip.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algebra/decide/decide.h"
#include "check/question/question.h"
#include "elaborate/name/names.h"

namespace rigor {

class DecisionCache;

/// The averages that a question is about, their values by linearity put in.
[[nodiscard]] std::vector<SymbolId> averages_of(const Question& question);

/// Is anything left of them by linearity?
[[nodiscard]] bool speaks_of_averages(ExprTree& tree, Prepared& prepared);

/// `\langle xy\rangle = \langle x\rangle\langle y\rangle`: by linearity, its sides are no sums of the same
/// products of averages, or opposite ones: `\langle x\rangle = \langle -x\rangle`, by symmetry.
[[nodiscard]] bool relates_different_averages(ExprTree& tree, Prepared& prepared, DecisionCache* cache);

struct TwoOutcomes {
  Sample sample;         // of the question itself
  std::string outcomes;  // "`x` is 0 or 1"
};
/// A sample that two outcomes have. Nothing where none was found, or where nothing shows that all letters in
/// the averages do change.
[[nodiscard]] std::optional<TwoOutcomes> refuted_by_two_outcomes(ExprTree& tree, const Names& names,
                                                                 const Prepared& prepared,
                                                                 const Limits& limits, DecisionCache* cache);

}  // namespace rigor
