// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/reading/placed_letters.h"

#include <utility>

#include "base/among.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

bool holds_words(const Token& token) {
  return is_words(token) || is_control_of(token, {"mathrm", "operatorname", "begin", "end", "label", "tag"});
}

bool is_written_letter(const Token& token) {
  if (token.kind == TokenKind::letter) return token.text != "d";
  return token.kind == TokenKind::control &&
         (is_greek(letter_of(token)) || is_control_of(token, {"hbar", "ell"}));
}

/// A face, or an accent that makes another symbol: `\mathbf`, `\hat`.
bool gives_face(const Token& token) { return style_of(token).has_value() && dots_of(token) == 0; }

}  // namespace

std::vector<PlacedLetter> letters_in(TokenView side) {
  std::vector<PlacedLetter> letters;
  for (std::size_t k = 0; k < side.size(); ++k) {
    if (holds_words(side[k])) {
      k = argument_at(side, k + 1).next - 1;
    } else if (side[k].kind == TokenKind::subscript) {
      k = script_argument_at(side, k + 1).next - 1;
    } else if (is_written_letter(side[k])) {
      const bool braced = k > 1 && side[k - 1].kind == TokenKind::begin_group && gives_face(side[k - 2]) &&
                          is_kind_at(side, k + 1, TokenKind::end_group);
      const bool bare = k > 0 && gives_face(side[k - 1]);
      PlacedLetter letter{.at = k, .begin = braced ? k - 2 : bare ? k - 1 : k, .end = braced ? k + 2 : k + 1};
      if (braced || bare) letter.face = side[letter.begin].text;
      letters.push_back(letter);
    }
  }
  return letters;
}

bool never_changes(TokenView letter) {
  if (!letter.empty() && is_control_of(letter[0], {"mathrm", "text", "operatorname"})) return true;
  return letter.size() == 1 && is_one_of(letter_of(letter[0]), {"i", "j", "e", "\\pi"});
}

std::vector<PieceLevel> levels_with_exponents(TokenView side) {
  std::vector<PieceLevel> levels = levels_of(side);
  for (std::size_t k = 0; k + 1 < side.size(); ++k) {
    if (side[k].kind != TokenKind::superscript) continue;
    const Argument exponent = argument_at(side, k + 1);
    if (exponent.content.size() < 2) continue;
    for (PieceLevel& level : levels_of(exponent.content)) {
      level.whole_side = false;
      levels.push_back(std::move(level));
    }
  }
  return levels;
}

std::vector<const Token*> indices_in(TokenView subscript) {
  std::vector<const Token*> indices;
  for (const Token& token : subscript) {
    if (holds_words(token)) return {};
    if (token.kind == TokenKind::letter || token.kind == TokenKind::digit) indices.push_back(&token);
  }
  return indices;
}

}  // namespace rigor
