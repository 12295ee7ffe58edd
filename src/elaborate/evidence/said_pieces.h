// SPDX-License-Identifier: GPL-3.0-or-later
// The words of a section and the formulas set in its lines, in their order.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/among.h"
#include "base/ascii.h"

namespace rigor {

/// A word in small letters, a sign such as `,`, or a formula between dollars.
struct SaidPiece {
  std::string text;
  bool formula = false;
};

/// Blanks, hyphens and opening brackets are left out.
[[nodiscard]] std::vector<SaidPiece> said_pieces(std::string_view text);

template <std::size_t n>
[[nodiscard]] bool is_word_of(const std::array<std::string_view, n>& words, const SaidPiece& piece) {
  return !piece.formula && is_one_of(piece.text, words);
}

/// A capital alone.
[[nodiscard]] inline bool holds_capital(const SaidPiece& piece) {
  return piece.formula && is_capital_letter(piece.text);
}

}  // namespace rigor
