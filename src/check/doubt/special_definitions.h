// SPDX-License-Identifier: GPL-3.0-or-later
// Proofs that rest on a definition for one case: `y = x \quad (x < 1)`, `I = ml^2/3` after "if the
// rod is thin", `n = 1` below "In vacuum", `a = 2b` in an example.
#pragma once

#include "check/doubt/borrowed.h"

namespace rigor {

/// `v_0 = 0` of "A ball is dropped", below "A ball that is thrown has": a value, an example or a choice of
/// units that another paragraph makes.
[[nodiscard]] bool is_case_of_another_paragraph(const ExprTree& tree, const Standpoint& at,
                                                const NamedDefinition& named);

/// Is the definition said for another case than that of the place?
[[nodiscard]] bool is_of_another_case(const ExprTree& tree, const Standpoint& at,
                                      const NamedDefinition& named);

/// The judgement of a step that was proved: as it is without definitions that are said for another case, or
/// that the page calls wrong in the place of the step. Cost: one more decision, where there are such.
[[nodiscard]] Judgement heed_cases(ExprTree& tree, const Names& names, const Claim& claim,
                                   Judgement judgement, const Standpoint& at, DecisionCache* cache);

}  // namespace rigor
