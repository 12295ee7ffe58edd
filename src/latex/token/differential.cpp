// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/token/differential.h"

#include "base/ascii.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

bool is_d(const Token& token) { return token.kind == TokenKind::letter && token.text == "d"; }

/// The place after the sign itself; `at` where there is none.
std::size_t behind_sign(TokenView tokens, std::size_t at) {
  if (is_d(tokens[at]) || is_partial(tokens[at]) || is_control(tokens[at], "dd") ||
      is_control(tokens[at], "differential"))
    return at + 1;
  const auto style = style_of(tokens[at]);
  if (!is_words(tokens[at]) && !(style && style->upright)) return at;
  const Argument argument = argument_at(tokens, at + 1);
  const TokenView content = trim(argument.content);
  return content.size() == 1 && is_d(content[0]) ? argument.next : at;
}

int order_in(TokenView content) {
  content = trim(content);
  const bool digit = content.size() == 1 && content[0].kind == TokenKind::digit;
  return digit ? content[0].text[0] - '0' : 0;
}

bool is_accent(const Token& token) { return style_of(token).has_value() || dots_of(token) > 0; }

std::size_t scripts_end(TokenView tokens, std::size_t at) {
  while (true) {
    const std::size_t script = skip_blank(tokens, at);
    if (script >= tokens.size()) return at;
    if (is_sign(tokens[script], "'")) {
      at = script + 1;
    } else if (tokens[script].kind == TokenKind::subscript || tokens[script].kind == TokenKind::superscript) {
      at = script_argument_at(tokens, script + 1).next;
    } else {
      return at;
    }
  }
}

}  // namespace

bool is_partial(const Token& token) {
  return is_control(token, "partial") || (token.kind == TokenKind::letter && token.text == "∂");
}

std::optional<Differential> differential_at(TokenView tokens, std::size_t at) {
  if (at >= tokens.size()) return std::nullopt;
  Differential found{behind_sign(tokens, at), 1, is_partial(tokens[at])};
  if (found.next == at) return std::nullopt;
  const std::size_t script = skip_blank(tokens, found.next);
  if (script >= tokens.size()) return found;
  if (tokens[script].kind == TokenKind::subscript || is_sign(tokens[script], "'")) return std::nullopt;
  if (tokens[script].kind == TokenKind::superscript) {
    const Argument order = script_argument_at(tokens, script + 1);
    found.order = order_in(order.content);
    found.next = order.next;
  } else if (tokens[at].kind == TokenKind::control) {  // \dd[3]{r}
    const Argument order = optional_argument_at(tokens, found.next);
    if (order.next != found.next) found.order = order_in(order.content);
    found.next = order.next;
  }
  return found;
}

std::size_t symbol_end(TokenView tokens, std::size_t at) {
  std::size_t end = skip_blank(tokens, at);
  if (end >= tokens.size()) return at;
  if (!is_accent(tokens[end])) return letter_of(tokens[end]).empty() ? at : scripts_end(tokens, end + 1);
  while (end < tokens.size() && is_accent(tokens[end])) {
    end = skip_blank(tokens, end + 1);
    if (is_sign_at(tokens, end, "*")) end = skip_blank(tokens, end + 1);
  }
  return scripts_end(tokens, argument_at(tokens, end).next);
}

std::size_t bracket_end(TokenView tokens, std::size_t at) {
  const std::size_t open = skip_blank(tokens, at);
  if (open >= tokens.size() || (!is_sign_of(tokens[open], "(["))) return at;
  Nesting nesting(false);
  for (std::size_t end = open; end < tokens.size(); ++end) {
    const int depth = nesting.enter(tokens[end]);
    if (end > open && depth == 0) return end + 1;
  }
  return at;
}

std::size_t skip_narrow(TokenView tokens, std::size_t at) {
  while (at < tokens.size() && (is_blank(tokens[at]) || is_spacing(tokens[at]))) ++at;
  return at;
}

}  // namespace rigor
