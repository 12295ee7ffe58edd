// SPDX-License-Identifier: GPL-3.0-or-later
// Where noun phrases stand among the tokens of a display, and what stands beside each: signs, relations,
// factors. Whether it is a quantity there, `quantity_words.h` tells.
#pragma once

#include <cstdint>
#include <vector>

#include "latex/token/tokens.h"

namespace rigor {

/// What stands on one side of a word.
enum class Neighbour : std::uint8_t {
  nothing,  // the end of the stretch, of a cell, a comma, a bracket that holds the word
  sign,     // of a sum or a product
  relation,
  factor,
  bracket,  // what opens behind the word: an argument, or a factor
  words,    // of a sentence
};

/// Words at a place where an operand can stand.
struct PlacedWord {
  TokenView tokens;  // with their control and braces
  Token letter;      // for all of them
  TokenView inner;   // `_g` of `\mathrm{PE_g}`
  Neighbour left = Neighbour::nothing;
  Neighbour right = Neighbour::nothing;
  bool left_is_upright = false;  // another such word is beside it
  bool right_is_upright = false;
  bool fills_slot = false;   // of a fraction or a root
  bool raised = false;       // inside an exponent
  bool among_words = false;  // nothing but words, numbers and signs is left of its relation
  bool explains = false;     // one letter is left of its relation
};

/// In the order of the tokens. Nobody looks into subscripts, and into arguments of controls that are not
/// known to hold an expression.
[[nodiscard]] std::vector<PlacedWord> placed_words(TokenView tokens);

}  // namespace rigor
