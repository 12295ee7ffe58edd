// SPDX-License-Identifier: GPL-3.0-or-later
// One side of a statement as tokens: which tokens are signs, products and
// factors, and what is inside what. Independent of the parser, so that edits of the text test it, and
// serve the search for what was meant.
#pragma once

#include <cstdint>
#include <vector>

#include "latex/token/tokens.h"

namespace rigor {

enum class PieceKind : std::uint8_t {
  plus,
  minus,
  cross,    // \times, \cross
  product,  // \cdot, \vdot, /
  factor,   // with its scripts: `r_\alpha^2`, `(a + b)^2`, `\frac{1}{2}`, `\triple{a}{b}{c}`
  bars,     // a factor in bars: |a|, \abs{a}
  big_sum,  // \sum_\alpha
};

struct Piece {
  PieceKind kind;
  TokenView tokens;
  TokenView inside = {};  // of bars
};

/// Pieces side by side at one depth of brackets. Layout (blanks, `&`, `\\`, spacing) is left out.
struct PieceLevel {
  std::vector<Piece> pieces;
  bool whole_side = false;
  bool may_be_sum = false;  // in brackets, bars or an argument such as that of \frac; not that of \mathbf
};

/// One additive term: its pieces, and the sign before it if one was typed.
struct PieceTerm {
  const Piece* sign = nullptr;
  TokenView tokens;
};

/// The side itself, then what is in its brackets, bars and arguments.
[[nodiscard]] std::vector<PieceLevel> levels_of(TokenView side);
[[nodiscard]] std::vector<PieceTerm> terms_of(const PieceLevel& level);

/// What is in each subscript, those of `\sum` left out.
[[nodiscard]] std::vector<TokenView> subscripts_of(TokenView side);

}  // namespace rigor
