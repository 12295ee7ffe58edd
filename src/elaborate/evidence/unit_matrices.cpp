// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/evidence/evidence.h"

#include <array>
#include <string>
#include <vector>

#include "base/among.h"
#include "base/ascii.h"

namespace rigor {
namespace {

/// A word in small letters, or a formula between dollars.
struct WordOrFormula {
  std::string text;
  bool formula = false;
};

std::vector<WordOrFormula> pieces_of(std::string_view text) {
  std::vector<WordOrFormula> pieces;
  for (std::size_t at = 0; at < text.size();) {
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
bool is_word_of(const std::array<std::string_view, n>& words, const WordOrFormula& piece) {
  return !piece.formula && is_one_of(piece.text, words);
}

constexpr std::array<std::string_view, 2> unit_words{"unit", "identity"};
constexpr std::array<std::string_view, 4> kinds{"matrix", "operator", "transformation", "map"};
constexpr std::array<std::string_view, 4> naming{"is", "denotes", "be", "for"};
constexpr std::array<std::string_view, 3> articles{"the", "a", "an"};

/// A capital alone.
bool holds_letter(const WordOrFormula& piece) { return piece.formula && is_capital_letter(piece.text); }

}  // namespace

void see_unit_matrices(std::string_view text, Evidence& evidence) {
  const std::vector<WordOrFormula> pieces = pieces_of(text);
  const auto add = [&](const WordOrFormula& letter) {
    evidence.units.insert(letter.text);
    evidence.ordered.insert(letter.text);
  };
  for (std::size_t at = 0; at + 1 < pieces.size(); ++at) {
    if (!is_word_of(unit_words, pieces[at]) || !is_word_of(kinds, pieces[at + 1])) continue;
    if (at + 2 < pieces.size() && holds_letter(pieces[at + 2])) add(pieces[at + 2]);  // the unit matrix $I$
    std::size_t before = at;
    if (before > 0 && is_word_of(articles, pieces[before - 1])) --before;
    if (before > 1 && is_word_of(naming, pieces[before - 1]) && holds_letter(pieces[before - 2]))
      add(pieces[before - 2]);  // $I$ is the unit matrix
  }
}

}  // namespace rigor
