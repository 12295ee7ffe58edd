// SPDX-License-Identifier: GPL-3.0-or-later
// The words by which an explanation calls what a question rests on.
#pragma once

#include <string>
#include <vector>

#include "check/question/question.h"
#include "expr/statement/question_names.h"

namespace rigor {

/// `definition I_{ij} (8)` is `Eq. (8)`; without a tag it is the definition of its symbol. What a kind
/// implies is called by the kind.
[[nodiscard]] QuestionNames names_of(const Prepared& prepared);

/// Why a symbol is 0 that nothing defines: what it is a derivative of does not change.
[[nodiscard]] std::string name_of_zero(const ExprTree& tree, SymbolId symbol);

/// Where the definitions come from that were unfolded, and what was put into these.
[[nodiscard]] std::vector<const Origin*> origins_of(const Prepared& prepared,
                                                    const std::vector<SymbolId>& unfolded);

}  // namespace rigor
