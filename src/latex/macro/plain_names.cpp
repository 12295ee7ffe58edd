// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/macro/plain_names.h"

#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

/// `\mathrm d`, `\mathrm{d}`, `\operatorname{d}`: the place behind it; `at` itself for anything else.
std::size_t behind_upright_d(TokenView tokens, std::size_t at) {
  const auto style = at < tokens.size() ? style_of(tokens[at]) : std::nullopt;
  if (!style || !style->upright) return at;
  const Argument argument = argument_at(tokens, at + 1);
  const TokenView content = trim(argument.content);
  return content.size() == 1 && is_letter(content[0], "d") ? argument.next : at;
}

}  // namespace

std::optional<Token> sign_named(std::string_view control) {
  static const WordMap<std::string_view> signs{{"lbrack", "["},
                                               {"rbrack", "]"},
                                               {"lparen", "("},
                                               {"rparen", ")"},
                                               {"colon vcentcolon ordinarycolon", ":"}};
  static const WordMap<TokenKind> scripts{{"sp", TokenKind::superscript}, {"sb", TokenKind::subscript}};
  if (const auto sign = signs.find(control)) return Token{TokenKind::other, *sign, {}};
  if (const auto script = scripts.find(control))
    return Token{*script, *script == TokenKind::subscript ? "_" : "^", {}};
  return std::nullopt;
}

bool is_spacing_class(std::string_view control) {
  static const WordSet classes("mathop mathbin mathrel mathord mathinner mathpunct");
  return classes.contains(control);
}

bool holds_no_more_than_differential(TokenView content) {
  bool seen = false;
  for (std::size_t at = 0; at < content.size();) {
    if (is_spacing(content[at])) {
      ++at;
      continue;
    }
    const std::size_t next = behind_upright_d(content, at);
    if (seen || next == at) return false;
    seen = true;
    at = next;
  }
  return true;
}

}  // namespace rigor
