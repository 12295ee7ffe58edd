// SPDX-License-Identifier: GPL-3.0-or-later
// Claims about sums up to a letter, `\sum_{k=1}^n k = \frac{n(n+1)}{2}`. They are meant for whole numbers
// only: so they are refuted at whole numbers, and can be proved by induction.
#pragma once

#include <optional>

#include "elaborate/name/names.h"
#include "expr/statement/statement.h"

namespace rigor {

/// What the sums of a claim count to.
struct CountedLetter {
  SymbolId letter{};
  int first = 0;             // with this number every sum has a term
  bool by_induction = true;  // each sum begins with a number, and nothing else says what the letter is
};

/// Do sums of the claim, or of what its letters are defined as, have limits that are no numbers?
[[nodiscard]] bool counts_to_letters(const ExprTree& tree, const Names& names, const Equation& claim);
/// The letter, if there is one for all of them.
[[nodiscard]] std::optional<CountedLetter> counted_letter(ExprTree& tree, const Names& names,
                                                          const Equation& claim);
/// The same names where the letter is this number.
[[nodiscard]] Names at_number(ExprTree& tree, const Names& names, SymbolId letter, int number);
/// The claim with n + 1 for n; nothing where that is not plain.
[[nodiscard]] std::optional<Equation> advanced(ExprTree& tree, const Equation& claim, SymbolId letter);

}  // namespace rigor
