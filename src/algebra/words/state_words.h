// SPDX-License-Identifier: GPL-3.0-or-later
// Kets among operators: ⟨a|X|b⟩ is a number that commutes with all, and its conjugate is ⟨b|X†|a⟩. What a law
// says of |n⟩ for any n, it says of |n + 1⟩ and |0⟩.
#pragma once

#include <functional>
#include <utility>
#include <vector>

#include "algebra/words/word_rules.h"
#include "algebra/words/word_sum.h"

namespace rigor {

[[nodiscard]] bool holds_kets(const WordSum& sum, const ExprTree& tree);

/// A bra before a ket, with operators between, is taken out of each word. `rules`, which `used` names, bring
/// the conjugates into the same form; they may be missing.
[[nodiscard]] WordSum with_brackets_out(const WordSum& sum, CommutingParts& parts, const WordRules* rules,
                                        Positions& used);

/// What is 0, and by which assumption.
using LawsOfStates = std::vector<std::pair<WordSum, std::size_t>>;

/// The laws for the kets below `roots`, and for those that these lead to. `read` reads a number.
[[nodiscard]] LawsOfStates laws_of_other_states(const LawsOfStates& laws, const std::vector<ExprId>& roots,
                                                CommutingParts& parts,
                                                const std::function<WordSum(ExprId)>& read);

}  // namespace rigor
