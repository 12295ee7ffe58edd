// SPDX-License-Identifier: GPL-3.0-or-later
// Does a row follow from what the page states? `m\ddot x = -kx` is a law: it is meant for some values only,
// and nothing on the page proves it. With `\omega^2 = k/m`, the row `\ddot x + \omega^2x = 0` follows from
// it.
//
// A wrong law proves wrong results, and two special cases together prove anything: `m\ddot x = -kx` and
// `m\ddot x = kx` leave only x = 0, for which `m\ddot x = 7kx` holds, too. So a set of laws proves a row only
// if some sample meets the set on which no letter, no term and no side of the row or of these laws is 0,
// unless a 0 is written. On such a sample the row is false with any sign turned or any factor put to a term,
// so none of these twins follows from the set.
#pragma once

#include <optional>

#include "check/law/page_law.h"
#include "check/verdict/judge.h"

namespace rigor {

/// What may be used, in the order of the notes.
struct AvailableLaws {
  Laws all;
  Laws named = {};  // of these, by the sentence: "From (2.1)"
};

/// Proved, with the smallest set of laws that was found, or a law that is restated, with its name under
/// `uses`; nothing if neither is so. A few sets of laws are tried: those that are named, and those that share
/// letters with the claim, bring in few others and stand near it come first. That takes at
/// most a share of the work that the step may take.
/// `inferred`: behind an arrow a row that says again what a law says is proved from it.
[[nodiscard]] std::optional<Judgement> follow_from_laws(ExprTree& tree, const Names& names,
                                                        const Claim& claim, const AvailableLaws& available,
                                                        bool inferred, DecisionCache& cache);

/// Do laws say how the operators of the row are multiplied, and is it not by them? Then it is no further law.
[[nodiscard]] bool is_denied_by_laws(ExprTree& tree, const Names& names, const Claim& claim,
                                     const Laws& available, DecisionCache& cache);

}  // namespace rigor
