// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/unit/quantity_words.h"

#include <algorithm>

#include "latex/token/vocabulary.h"
#include "latex/unit/quantity_names.h"
#include "latex/unit/quantity_places.h"

namespace rigor {
namespace {

bool is_between(Neighbour neighbour) {
  return neighbour == Neighbour::nothing || neighbour == Neighbour::sign || neighbour == Neighbour::relation;
}

/// The whole first side of a relation says that words are a quantity, and so does such a side of the other
/// words. Elsewhere only symbols are: in two sums, "friction" and "total derivative" can be two things.
bool is_shown(const PlacedWord& word) {
  if (!is_between(word.left) || !is_between(word.right) || word.raised) return false;
  const bool sign = word.left == Neighbour::sign || word.right == Neighbour::sign;
  const bool first_side = word.left == Neighbour::nothing && word.right == Neighbour::relation;
  if (can_say_property(word.letter.text)) return false;
  return first_side || word.among_words ||
         ((sign || word.fills_slot) && is_symbol_of_letters(word.letter.text));
}

/// A word that other rows show to be a quantity.
bool is_known(const PlacedWord& word) {
  if (word.right == Neighbour::bracket || word.right == Neighbour::words) return false;
  if (word.left == Neighbour::words && word.right == Neighbour::nothing) return false;  // `a = b~\text{KE}`
  const bool alone = word.left == Neighbour::nothing && word.right == Neighbour::nothing;
  const bool symbol = is_symbol_of_letters(word.letter.text);
  if (word.explains && word.right != Neighbour::sign && !symbol) return false;  // `m_1 = \text{mass}`
  if (is_between(word.left) && is_between(word.right)) return !alone || word.raised || word.fills_slot;
  const bool acts = word.right == Neighbour::factor && !function_name(word.letter.text).empty();
  return symbol && (!acts || word.right_is_upright);
}

/// `_{\mathrm{grav}}` for the `_{grav}` of `\mathrm{PE_{grav}}`.
void add_inner_script(Tokens& result, TokenView script) {
  if (script.empty()) return;
  const TokenView label = script_argument_at(script, 1).content;
  const bool letters =
      std::ranges::all_of(label, [](const Token& token) { return token.kind == TokenKind::letter; });
  const Token open{TokenKind::begin_group, "{", script.front().span};
  const Token close{TokenKind::end_group, "}", script.back().span};
  result.insert(result.end(), {script.front(), open});
  if (letters) result.insert(result.end(), {Token{TokenKind::control, "mathrm", open.span}, open});
  result.insert(result.end(), label.begin(), label.end());
  if (letters) result.push_back(close);
  result.push_back(close);
}

template <class Chosen>
Tokens with_letters_for(Tokens tokens, const Chosen& is_chosen) {
  Tokens result;
  std::size_t at = 0;
  for (const PlacedWord& word : placed_words(tokens)) {
    if (!is_chosen(word)) continue;
    const auto begin = static_cast<std::size_t>(word.tokens.data() - tokens.data());
    result.insert(result.end(), tokens.begin() + static_cast<std::ptrdiff_t>(at),
                  tokens.begin() + static_cast<std::ptrdiff_t>(begin));
    result.push_back(word.letter);
    add_inner_script(result, word.inner);
    at = begin + word.tokens.size();
  }
  result.insert(result.end(), tokens.begin() + static_cast<std::ptrdiff_t>(at), tokens.end());
  return result;
}

}  // namespace

void add_quantity_words(TokenView tokens, std::set<std::string>& shown) {
  for (const PlacedWord& word : placed_words(tokens)) {
    if (is_shown(word)) shown.insert(letter_of(word.letter));
  }
}

Tokens with_quantity_words(Tokens tokens, const std::set<std::string>& shown) {
  return with_letters_for(std::move(tokens), [&](const PlacedWord& word) {
    return is_shown(word) || (shown.contains(letter_of(word.letter)) && is_known(word));
  });
}

Tokens with_named_words(Tokens tokens) {
  return with_letters_for(std::move(tokens), [](const PlacedWord& word) {
    return is_shown(word) || (is_between(word.left) && is_between(word.right));
  });
}

}  // namespace rigor
