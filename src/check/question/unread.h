// SPDX-License-Identifier: GPL-3.0-or-later
// Assumptions that could not be read. They may make a claim about the same letters true, so such a claim is
// not refuted.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "elaborate/name/names.h"
#include "expr/statement/statement.h"

namespace rigor {

/// The letters in LaTeX, without faces, accents, subscripts and words: `\bar{a}\cdot\omega_n` has `a` and
/// `\omega`.
[[nodiscard]] std::set<std::string> letters_of(std::string_view latex);

/// The last one in force that shares a letter with the claim or with what defines it; null if there is none.
[[nodiscard]] const UnreadAssumption* unread_assumption(const ExprTree& tree, const Names& names,
                                                        const Question& question);

/// What a question is about: all symbols of its claim, definitions and assumptions.
[[nodiscard]] std::vector<SymbolId> symbols_of(const Question& question);

}  // namespace rigor
