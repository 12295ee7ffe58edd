// SPDX-License-Identifier: GPL-3.0-or-later
// The displays of notes, token by token: does each belong to something, and does each make a difference?
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "latex/token/tokens.h"
#include "source/source_map.h"

namespace rigor::exchange {

/// A display with its macros expanded. Tokens are views into the sources.
struct TokenDisplay {
  Tokens tokens;
  std::string environment;
};
[[nodiscard]] std::vector<TokenDisplay> displays_of(SourceMap& sources, FileId file);

struct Tally {
  std::size_t displays = 0;
  std::size_t statements = 0;
  std::size_t not_understood = 0;  // statements of which a part is not read
  std::size_t tokens = 0;
  std::size_t exchanged = 0;
  std::size_t inserted = 0;
  std::size_t left_over = 0;                    // tokens that belong to nothing, where something is judged
  std::vector<std::string> no_difference = {};  // places of tokens whose exchange changes nothing

  void add(const Tally& other);
};

/// Each token in turn becomes a letter that does not occur. What changes nothing is found in what is read of
/// the sides, not in how they are written.
[[nodiscard]] Tally exchange_tokens(const SourceMap& sources, const TokenDisplay& display);

/// At each letter of a side a superscript, a prime or a word that acts is added, which must not be passed
/// over.
[[nodiscard]] Tally insert_signs(const SourceMap& sources, const TokenDisplay& display);

}  // namespace rigor::exchange
