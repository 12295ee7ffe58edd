// SPDX-License-Identifier: GPL-3.0-or-later
// A question about operators as questions about numbers: the sides become sums of words, and the coefficient
// of each word of their difference is to be 0. What is proved so holds for operators on any space, bounded or
// not, on the vectors on which all products are defined.
//
// Why here and not in the evaluator: then nothing above has to know that products have an order, and no
// product of operators reaches the commutative engine.
#pragma once

#include <functional>
#include <optional>

#include "algebra/engine/limits.h"
#include "expr/statement/statement.h"

namespace rigor {

/// Does an operator occur, also in definitions that are reached, or in assumptions?
[[nodiscard]] bool is_about_operators(const Question& question);

/// Decides a question without operators.
using DecideNumbers = std::function<Decision(const Question& question, const Limits& limits)>;

/// Proved or undecided: as an identity for all operators, or by what the assumptions say of them, brought
/// into a normal form. Throws Undecidable.
[[nodiscard]] Decision decide_operators(const Question& question, const Limits& limits,
                                        const DecideNumbers& decide);

/// Are the coefficients of all words equal by the rules, as far as some values of their letters show?
/// Definitions of operators are unfolded.
[[nodiscard]] bool holds_in_words(const Question& question, const Limits& limits);

/// The rational number c ≠ 0 for which the claim's left − right = c · term by the rules alone, for all values
/// of its free indices. The term, of the claim's rank, is given as `term = 0`.
[[nodiscard]] std::optional<std::string> multiple_in_words(const Question& question, const Equation& term,
                                                           const Limits& limits);

/// Can the assumptions about operators hold together? By the diamond lemma they can where all pairs of rules
/// lead to one end, and what is assumed not to vanish has another normal form than 0. `numbers`: what is
/// assumed besides.
[[nodiscard]] bool operators_can_satisfy(const Question& question, const Limits& limits, Question& numbers);

/// Has the difference of the sides products of several lengths, definitions unfolded? `AB = BA + 1` says
/// something of A and B; an identity mends no such difference. True where it cannot be read.
[[nodiscard]] bool differs_in_several_degrees(const Question& question);

/// Do the assumptions say how the operators of the claim are multiplied, and leave something of the
/// difference of its sides? Then it is not by them, and no further law beside them: its greatest word is one
/// that they replace. Only where all pairs of rules lead to one end.
[[nodiscard]] bool operators_deny(const Question& question, const Limits& limits);

}  // namespace rigor
