// SPDX-License-Identifier: GPL-3.0-or-later
// What stands next to the values of `\begin{cases} … \end{cases}`: `x > 0`, `\text{if } 0 \le x < L`,
// `x < 0 \text{ or } x > L`, `x \in [0, 1)`, "otherwise".
#pragma once

#include <vector>

#include "latex/token/tokens.h"

namespace rigor {

/// When a case holds: in one alternative or another, each of which is relations that hold together. None: it
/// is not read.
struct CaseConditions {
  std::vector<std::vector<Tokens>> alternatives = {};
};

/// Of all cases of a display, in their order. "Otherwise" is that none of the others holds. `in_words`: they
/// are words, with mathematics between dollar signs. Empty: no condition is a relation of quantities.
[[nodiscard]] std::vector<CaseConditions> conditions_of_cases(const std::vector<TokenView>& written,
                                                              bool in_words);

}  // namespace rigor
