// SPDX-License-Identifier: GPL-3.0-or-later
// Brackets of quantum mechanics: of states, and of two operators.
#include <algorithm>

#include "base/among.h"
#include "latex/parse/parser.h"
#include "latex/token/cover_tokens.h"

namespace rigor {
namespace {

std::size_t behind_stars(TokenView tokens, std::size_t at) {
  while (is_sign_at(tokens, at, "*")) ++at;
  return skip_blank(tokens, at);
}

/// `\langle a | H | b\rangle`, `\langle a |`: the place behind it.
std::size_t behind_angles(TokenView tokens, std::size_t open) {
  int depth = 0;
  for (std::size_t at = open; at < tokens.size(); ++at) {
    if (is_control(tokens[at], "langle")) ++depth;
    if (is_control(tokens[at], "rangle") && --depth == 0) return at + 1;
  }
  const auto is_bar = [](const Token& token) {
    return is_sign(token, "|") || is_control_of(token, {"vert", "rvert"});
  };
  const auto bar = std::ranges::find_if(tokens.subspan(open), is_bar);
  const auto behind = static_cast<std::size_t>(bar - tokens.begin());
  return behind < tokens.size() ? behind + 1 : open + 1;
}

}  // namespace

/// One obstacle for the whole of it.
std::optional<SyntaxId> Parser::state_bracket(Cursor& cursor) {
  const TokenView tokens = cursor.tokens;
  const std::size_t begin = cursor.at;
  if (is_control(tokens[begin], "langle")) {
    cursor.at = behind_angles(tokens, begin);
  } else if (is_state_bracket(tokens[begin])) {
    std::size_t at = behind_stars(tokens, begin + 1);
    cursor.at = argument_at(tokens, at).next;
    for (at = skip_blank(tokens, cursor.at); is_kind_at(tokens, at, TokenKind::begin_group);
         at = skip_blank(tokens, cursor.at))
      cursor.at = argument_at(tokens, at).next;
  } else {
    return std::nullopt;
  }
  return opaque(cover(tokens[begin].span, tokens.subspan(begin, cursor.at - begin)),
                "brackets of states or averages are not read");
}

/// `\comm{A}{B}` is `[A, B]` and `\acomm{A}{B}` is `\{A, B\}`; `\pb` is no commutator, whatever is in it.
std::optional<SyntaxId> Parser::pair_in_brackets(Cursor& cursor) {
  static const WordSet names("comm commutator acomm anticommutator pb poissonbracket");
  const TokenView tokens = cursor.tokens;
  const std::size_t begin = cursor.at;
  if (!is_control_of(tokens[begin], names)) return std::nullopt;
  const std::uint32_t pair = is_control_of(tokens[begin], {"comm", "commutator"})     ? in_square_brackets
                             : is_control_of(tokens[begin], {"pb", "poissonbracket"}) ? in_poisson_brackets
                                                                                      : in_braces;
  const std::size_t open = behind_stars(tokens, begin + 1);
  if (!is_kind_at(tokens, open, TokenKind::begin_group)) return std::nullopt;
  const Argument first = argument_at(tokens, open);
  const std::size_t again = skip_blank(tokens, first.next);
  if (!is_kind_at(tokens, again, TokenKind::begin_group)) return std::nullopt;
  const Argument second = argument_at(tokens, again);
  cursor.at = second.next;
  read_since(cursor, begin);
  const Span span = cover(tokens[begin].span, tokens.subspan(begin, second.next - begin));
  const SyntaxChild children[] = {{inner(first.content, span), Joint::comma, span},
                                  {inner(second.content, span), Joint::comma, span}};
  return tree_.add(SyntaxKind::tuple, span, children, pair);
}

}  // namespace rigor
