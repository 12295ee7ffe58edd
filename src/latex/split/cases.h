// SPDX-License-Identifier: GPL-3.0-or-later
// `f(x) = \begin{cases} x^2 & x > 0 \\ 0 & \text{otherwise} \end{cases}`: one statement for each case, under
// what is written next to its value. "Otherwise" is what the other cases leave; where that is one thing or
// another (`x < 0` or `x > L`), there are two statements.
#pragma once

#include <optional>
#include <vector>

#include "latex/token/accounting.h"
#include "latex/token/syntax.h"
#include "latex/token/tokens.h"

namespace rigor {

struct WrittenCase {
  Tokens statement;                // with the value in the place of all the cases
  std::vector<Tokens> conditions;  // relations, which hold together
  std::optional<Obstacle> unread;  // words in their place: they restrict it in a way that nobody knows
};

struct WrittenCases {
  Tokens before;  // `a = b,` of `a = b, \quad f = \begin{cases} …`: a statement of its own
  std::vector<WrittenCase> cases;
};

/// `\begin{numcases}{f(x) =} … \end{numcases}`: what is in it as `f(x) = \begin{cases*} … \end{cases*}`.
[[nodiscard]] Tokens numbered_cases(TokenView body);

/// Nothing where there are no cases, or none of their conditions is a relation of quantities: `\delta_{ij}`
/// by the values of its indices is read as a whole.
[[nodiscard]] std::optional<WrittenCases> cases_of(TokenView statement, TokenUses& uses);

}  // namespace rigor
