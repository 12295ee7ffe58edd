// SPDX-License-Identifier: GPL-3.0-or-later
// The letters of a side with their faces, wherever they stand: in arguments of functions, fractions and
// exponents as well.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "latex/reading/pieces.h"
#include "latex/token/tokens.h"

namespace rigor {

/// Tokens of the side from `begin` to `end`: `\mathbf{r}`, `x`. The letter itself is token `at`.
struct PlacedLetter {
  std::size_t at = 0;
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string_view face = {};  // the control that gives it; empty: plain
};

/// In their order. Not those of subscripts, words and differentials.
[[nodiscard]] std::vector<PlacedLetter> letters_in(TokenView side);

/// `i`, `e`, `\pi`, `\mathrm{i}`: a number as a rule, which takes no dot and no prime.
[[nodiscard]] bool never_changes(TokenView letter);

/// The levels of the side, then those of its exponents.
[[nodiscard]] std::vector<PieceLevel> levels_with_exponents(TokenView side);

/// Letters and digits of a subscript, unless it holds a word; they are tokens of it.
[[nodiscard]] std::vector<const Token*> indices_in(TokenView subscript);

}  // namespace rigor
