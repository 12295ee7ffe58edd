// SPDX-License-Identifier: GPL-3.0-or-later
// The words of a section and the formulas set in its lines, in their order.
#pragma once

#include <algorithm>
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
[[nodiscard]] inline std::vector<SaidPiece> said_pieces(std::string_view text) {
  std::vector<SaidPiece> pieces;
  for (std::size_t at = 0; at < text.size();) {
    if (text.substr(at).starts_with("<!--")) {
      at = std::min(text.find("-->", at), text.size() - 3) + 3;
      continue;
    }
    if (text[at] == '$') {
      const std::size_t close = text.find('$', at + 1);
      if (close == std::string_view::npos) break;
      pieces.push_back({std::string(text.substr(at + 1, close - at - 1)), true});
      at = close + 1;
      continue;
    }
    if (!is_letter(text[at])) {
      const bool blank = is_white(text[at]) || text[at] == '~' || text[at] == '-' || text[at] == '(';
      if (!blank) pieces.push_back({std::string(1, text[at]), false});
      ++at;
      continue;
    }
    const std::size_t begin = at;
    while (at < text.size() && is_letter(text[at])) ++at;
    pieces.push_back({lowered(text.substr(begin, at - begin)), false});
  }
  return pieces;
}

template <std::size_t n>
[[nodiscard]] bool is_word_of(const std::array<std::string_view, n>& words, const SaidPiece& piece) {
  return !piece.formula && is_one_of(piece.text, words);
}

/// A capital alone.
[[nodiscard]] inline bool holds_capital(const SaidPiece& piece) {
  return piece.formula && is_capital_letter(piece.text);
}

}  // namespace rigor
