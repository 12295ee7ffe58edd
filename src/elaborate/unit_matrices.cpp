// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/unit_matrices.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <vector>

namespace rigor {
namespace {

/// A word in small letters, or a formula between dollars.
struct Piece {
  std::string text;
  bool formula = false;
};

std::vector<Piece> pieces_of(std::string_view text) {
  std::vector<Piece> pieces;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == '$') {
      const std::size_t close = text.find('$', at + 1);
      if (close == std::string_view::npos) break;
      pieces.push_back({std::string(text.substr(at + 1, close - at - 1)), true});
      at = close + 1;
      continue;
    }
    if (std::isalpha(static_cast<unsigned char>(text[at])) == 0) {
      const bool blank = std::isspace(static_cast<unsigned char>(text[at])) != 0 || text[at] == '~' ||
                         text[at] == '-' || text[at] == '(';
      if (!blank) pieces.push_back({std::string(1, text[at]), false});
      ++at;
      continue;
    }
    std::string word;
    for (; at < text.size() && std::isalpha(static_cast<unsigned char>(text[at])) != 0; ++at)
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(text[at])));
    pieces.push_back({std::move(word), false});
  }
  return pieces;
}

template <std::size_t n>
bool is_one_of(const std::array<std::string_view, n>& words, const Piece& piece) {
  return !piece.formula && std::find(words.begin(), words.end(), piece.text) != words.end();
}

constexpr std::array<std::string_view, 2> unit_words{"unit", "identity"};
constexpr std::array<std::string_view, 4> kinds{"matrix", "operator", "transformation", "map"};
constexpr std::array<std::string_view, 4> naming{"is", "denotes", "be", "for"};
constexpr std::array<std::string_view, 3> articles{"the", "a", "an"};

/// A capital alone.
bool is_letter(const Piece& piece) {
  return piece.formula && piece.text.size() == 1 && piece.text[0] >= 'A' && piece.text[0] <= 'Z';
}

}  // namespace

void see_unit_matrices(std::string_view text, Evidence& evidence) {
  const std::vector<Piece> pieces = pieces_of(text);
  const auto add = [&](const Piece& letter) {
    evidence.units.insert(letter.text);
    evidence.ordered.insert(letter.text);
  };
  for (std::size_t at = 0; at + 1 < pieces.size(); ++at) {
    if (!is_one_of(unit_words, pieces[at]) || !is_one_of(kinds, pieces[at + 1])) continue;
    if (at + 2 < pieces.size() && is_letter(pieces[at + 2])) add(pieces[at + 2]);  // the unit matrix $I$
    std::size_t before = at;
    if (before > 0 && is_one_of(articles, pieces[before - 1])) --before;
    if (before > 1 && is_one_of(naming, pieces[before - 1]) && is_letter(pieces[before - 2]))
      add(pieces[before - 2]);  // $I$ is the unit matrix
  }
}

}  // namespace rigor
