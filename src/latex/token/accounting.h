// SPDX-License-Identifier: GPL-3.0-or-later
// Every sign counts: which tokens of a display were read, and as what. Whoever takes a token into a node, a
// tag or a remark says so; a token that nobody accounts for makes its statement not understood. So a place
// that forgets a token can lose a verdict, and never change what was written.
#pragma once

#include <cstdint>
#include <vector>

#include "latex/token/tokens.h"

namespace rigor {

/// What a token is to the statements of its display.
enum class TokenUse : std::uint8_t {
  none,      // nothing: it would be passed over
  side,      // part of a side of a chain; what becomes of it there, a `SideAccount` knows
  relation,  // between two sides
  name,      // a tag or a label
  layout,    // spacing, columns, sizes of brackets, punctuation at an end
  aside,   // what only sets a space or a colour with its argument; prose between rows: nothing of it is read
  remark,  // words from the list of remarks
  condition,  // it keeps its statement from being judged, or from being refuted
};

/// Signs that set braces, columns, spaces and styles of lines: they stand for nothing themselves.
[[nodiscard]] bool is_layout(const Token& token);

/// For the tokens of one display, which are counted from 1 (`Token::place`).
class TokenUses {
 public:
  explicit TokenUses(std::size_t count) : uses_(count, TokenUse::none) {}
  /// What says that a statement is not judged outlasts what is said later.
  void mark(TokenView tokens, TokenUse use);
  [[nodiscard]] TokenUse of(const Token& token) const;
  /// The first token that nobody used; nothing if there is none.
  [[nodiscard]] const Token* left_over(TokenView tokens) const;

 private:
  std::vector<TokenUse> uses_;
};

/// The tokens with their places; from then on copies of them can be told apart.
[[nodiscard]] Tokens counted(TokenView tokens);

/// Which tokens of one side are in its syntax tree.
class SideAccount {
 public:
  explicit SideAccount(TokenView side) : side_(side), read_(side.size(), false) {}
  /// `tokens` is a stretch of the side.
  void read(TokenView tokens);
  [[nodiscard]] const Token* left_over() const;

 private:
  TokenView side_;
  std::vector<bool> read_;
};

}  // namespace rigor
