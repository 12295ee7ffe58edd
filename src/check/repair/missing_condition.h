// SPDX-License-Identifier: GPL-3.0-or-later
// Which usual condition would make a refuted step true? The centre of mass, a symmetric tensor, a unit
// vector, something constant, principal axes, equal or ordered numbers, vectors at right angles, what is
// small.
#pragma once

#include <string>
#include <vector>

#include "check/repair/repair.h"

namespace rigor {

class DecisionCache;

inline constexpr std::size_t most_conditions = 2;

/// The conditions, in the notes' own symbols, as they can be given: `\sum_\alpha m_\alpha\mathbf{r}_\alpha =
/// 0`; the usual ones first. Method: each condition that the symbols behind the step allow is assumed, and
/// the step is decided again. One that no sample meets together with what is assumed already, and one under
/// which both sides vanish, say nothing and are left out. It works on copies.
/// `with_all_terms`: nor one under which a term that is written vanishes. Who means it leaves the term out.
[[nodiscard]] std::vector<std::string> missing_conditions(const ExprTree& tree, const Names& names,
                                                          const WrongStep& wrong,
                                                          DecisionCache* cache = nullptr,
                                                          bool with_all_terms = false);

/// `\sum_i p_i = 1` of what can be a weight: pages of probabilities and fractions do not write it.
[[nodiscard]] bool is_sum_of_weights(const std::string& condition);

}  // namespace rigor
