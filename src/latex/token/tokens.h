// SPDX-License-Identifier: GPL-3.0-or-later
// Questions that every pass over tokens asks: where a group ends, how deep a token lies, what a stretch
// covers.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "base/among.h"
#include "base/ascii.h"
#include "latex/token/token.h"
#include "latex/token/words.h"

namespace rigor {

using Tokens = std::vector<Token>;
using TokenView = std::span<const Token>;

[[nodiscard]] bool is_control(const Token& token, std::string_view name);
[[nodiscard]] bool is_sign(const Token& token, std::string_view text);  // TokenKind::other
[[nodiscard]] bool is_letter(const Token& token, std::string_view letter);
[[nodiscard]] bool is_blank(const Token& token);     // space or paragraph
[[nodiscard]] bool is_script(const Token& token);    // `_`, `^` or a prime
[[nodiscard]] bool is_sum_sign(const Token& token);  // `+`, `-`, `\pm`, `\mp`
/// What is at the place; false after the end.
[[nodiscard]] inline bool is_kind_at(TokenView tokens, std::size_t at, TokenKind kind) {
  return at < tokens.size() && tokens[at].kind == kind;
}
[[nodiscard]] inline bool is_sign_at(TokenView tokens, std::size_t at, std::string_view text) {
  return at < tokens.size() && is_sign(tokens[at], text);
}
[[nodiscard]] inline bool is_control_at(TokenView tokens, std::size_t at, std::string_view name) {
  return at < tokens.size() && is_control(tokens[at], name);
}
[[nodiscard]] inline bool is_script_at(TokenView tokens, std::size_t at) {
  return at < tokens.size() && is_script(tokens[at]);
}
/// One of the signs of one character.
[[nodiscard]] inline bool is_sign_of(const Token& token, std::string_view signs) {
  return token.kind == TokenKind::other && signs.find(token.text) != std::string_view::npos;
}
/// A control of the list.
[[nodiscard]] inline bool is_control_of(const Token& token, std::initializer_list<std::string_view> names) {
  return token.kind == TokenKind::control && is_one_of(token.text, names);
}
[[nodiscard]] inline bool is_control_of(const Token& token, const WordSet& names) {
  return token.kind == TokenKind::control && names.contains(token.text);
}

/// The first place at or after `at` that is not blank; the size at the end.
[[nodiscard]] std::size_t skip_blank(TokenView tokens, std::size_t at);

/// A macro argument: the contents of a brace group, or one token. `next` is the place after it; nothing
/// left: empty, next = size.
struct Argument {
  TokenView content;
  std::size_t next;
};
[[nodiscard]] Argument argument_at(TokenView tokens, std::size_t at);
/// The argument of `_` or `^`: as above, but a control that takes arguments comes with them (`_\mathrm{c}`,
/// `^\frac12`).
[[nodiscard]] Argument script_argument_at(TokenView tokens, std::size_t at);
/// The contents of `[…]` if one is there (blanks skipped), else nothing and next = at.
[[nodiscard]] Argument optional_argument_at(TokenView tokens, std::size_t at);

/// Is the token the argument of a `_` or `^` before it? `A_\perp` holds no relation.
[[nodiscard]] bool is_script_argument(TokenView tokens, std::size_t at);

/// The place after an empty group `{}` that is at `at` and carries no script; `at` itself otherwise.
/// Such a group means nothing.
[[nodiscard]] std::size_t skip_empty_group(TokenView tokens, std::size_t at);

/// `2pt`, `\smallskip`: only a length is an optional argument of `\\`; `\\ [A, B]` is not one.
[[nodiscard]] bool is_length(TokenView tokens);

/// The first brace that nothing closes or opens, if any.
[[nodiscard]] const Token* unbalanced_brace(TokenView tokens);

/// Depth of braces, environments and (unless `braces_only`) brackets, fed token by token; 0 is the outside.
class Nesting {
 public:
  explicit Nesting(bool braces_only) : braces_only_(braces_only) {}
  /// The depth at which the token lies (an opening and its closing token both lie outside).
  int enter(const Token& token);

 private:
  bool braces_only_;
  int depth_ = 0;
};

[[nodiscard]] Span span_of(TokenView tokens);  // empty for no tokens
/// The tokens' texts in a row, controls with their backslash, runs of blanks as one space, ends trimmed.
[[nodiscard]] std::string text_of(TokenView tokens);
[[nodiscard]] TokenView trim(TokenView tokens);

/// `[t]{|c|rl}` behind `\begin{array}`.
[[nodiscard]] bool are_columns(TokenView tokens);

}  // namespace rigor
