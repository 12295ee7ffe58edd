// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/evidence/evidence.h"

#include "elaborate/evidence/said_pieces.h"

namespace rigor {
namespace {

constexpr std::array<std::string_view, 2> unit_words{"unit", "identity"};
constexpr std::array<std::string_view, 4> kinds{"matrix", "operator", "transformation", "map"};
constexpr std::array<std::string_view, 4> naming{"is", "denotes", "be", "for"};
constexpr std::array<std::string_view, 3> articles{"the", "a", "an"};

}  // namespace

void see_unit_matrices(std::string_view text, Evidence& evidence) {
  const std::vector<SaidPiece> pieces = said_pieces(text);
  const auto add = [&](const SaidPiece& letter) {
    evidence.units.insert(letter.text);
    evidence.ordered.insert(letter.text);
  };
  for (std::size_t at = 0; at + 1 < pieces.size(); ++at) {
    if (!is_word_of(unit_words, pieces[at]) || !is_word_of(kinds, pieces[at + 1])) continue;
    if (at + 2 < pieces.size() && holds_capital(pieces[at + 2])) add(pieces[at + 2]);  // the unit matrix $I$
    std::size_t before = at;
    if (before > 0 && is_word_of(articles, pieces[before - 1])) {
      if (--before > 0 && holds_capital(pieces[before - 1]))
        add(pieces[before - 1]);  // and $I$ the unit matrix
    }
    if (before > 1 && is_word_of(naming, pieces[before - 1]) && holds_capital(pieces[before - 2]))
      add(pieces[before - 2]);  // $I$ is the unit matrix
  }
}

}  // namespace rigor
