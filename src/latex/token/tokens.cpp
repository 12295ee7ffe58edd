// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/token/tokens.h"

#include <algorithm>

#include "base/among.h"
#include "latex/token/vocabulary.h"

namespace rigor {

bool is_control(const Token& token, std::string_view name) {
  return token.kind == TokenKind::control && token.text == name;
}

bool is_sign(const Token& token, std::string_view text) {
  return token.kind == TokenKind::other && token.text == text;
}

bool is_letter(const Token& token, std::string_view letter) {
  return token.kind == TokenKind::letter && token.text == letter;
}
bool is_script(const Token& token) {
  return token.kind == TokenKind::subscript || token.kind == TokenKind::superscript || is_sign(token, "'");
}
bool is_sum_sign(const Token& token) {
  return is_sign_of(token, "+-") || is_letter(token, "−") || is_control(token, "pm") ||
         is_control(token, "mp");
}
bool is_blank(const Token& token) {
  return token.kind == TokenKind::space || token.kind == TokenKind::paragraph;
}

std::size_t skip_blank(TokenView tokens, std::size_t at) {
  while (at < tokens.size() && is_blank(tokens[at])) ++at;
  return at;
}

bool is_script_argument(TokenView tokens, std::size_t at) {
  while (at > 0 && is_blank(tokens[at - 1])) --at;
  return at > 0 &&
         (tokens[at - 1].kind == TokenKind::subscript || tokens[at - 1].kind == TokenKind::superscript);
}

Argument argument_at(TokenView tokens, std::size_t at) {
  at = skip_blank(tokens, at);
  if (at >= tokens.size()) return {{}, tokens.size()};
  if (tokens[at].kind != TokenKind::begin_group) return {tokens.subspan(at, 1), at + 1};
  int depth = 0;
  for (std::size_t i = at; i < tokens.size(); ++i) {
    if (tokens[i].kind == TokenKind::begin_group) ++depth;
    if (tokens[i].kind == TokenKind::end_group && --depth == 0)
      return {tokens.subspan(at + 1, i - at - 1), i + 1};
  }
  return {tokens.subspan(at + 1), tokens.size()};
}

Argument script_argument_at(TokenView tokens, std::size_t at) {
  Argument script = argument_at(tokens, at);
  at = skip_blank(tokens, at);
  if (!is_kind_at(tokens, at, TokenKind::control)) return script;
  const std::string_view name = tokens[at].text;
  const bool two = is_one_of(name, {"frac", "tfrac", "dfrac", "textcolor"});
  const bool one =
      name == "sqrt" || name.starts_with("math") || name.starts_with("text") ||
      is_one_of(name, {"mbox", "bm", "boldsymbol", "vec", "hat", "operatorname", "bar", "tilde", "vb"});
  for (int k = 0; k < (two ? 2 : one ? 1 : 0); ++k) script.next = argument_at(tokens, script.next).next;
  script.content = tokens.subspan(at, two || one ? script.next - at : 1);
  return script;
}

Argument optional_argument_at(TokenView tokens, std::size_t at) {
  const std::size_t open = skip_blank(tokens, at);
  if (!is_sign_at(tokens, open, "[")) return {{}, at};
  Nesting nesting(true);
  for (std::size_t i = open + 1; i < tokens.size(); ++i) {
    if (nesting.enter(tokens[i]) == 0 && is_sign(tokens[i], "]"))
      return {tokens.subspan(open + 1, i - open - 1), i + 1};
  }
  return {{}, at};
}

std::size_t skip_empty_group(TokenView tokens, std::size_t at) {
  if (!is_kind_at(tokens, at, TokenKind::begin_group)) return at;
  const std::size_t close = skip_blank(tokens, at + 1);
  if (!is_kind_at(tokens, close, TokenKind::end_group)) return at;
  const std::size_t behind = skip_blank(tokens, close + 1);
  const bool script = behind < tokens.size() && is_script(tokens[behind]);
  return script ? at : close + 1;
}

bool is_length(TokenView tokens) {
  const std::string text = text_of(tokens);
  if (text.find("skip") != std::string::npos || text.find("jot") != std::string::npos) return true;
  const auto letters = text.find_first_not_of("-+.0123456789 ");
  if (letters == std::string::npos || letters == 0) return false;
  static constexpr std::string_view units[] = {"pt", "em", "ex", "mm", "cm", "in", "mu"};
  return is_one_of(std::string_view(text).substr(letters), units);
}

const Token* unbalanced_brace(TokenView tokens) {
  std::vector<const Token*> open;
  for (const Token& token : tokens) {
    if (token.kind == TokenKind::begin_group) open.push_back(&token);
    if (token.kind != TokenKind::end_group) continue;
    if (open.empty()) return &token;
    open.pop_back();
  }
  return open.empty() ? nullptr : open.front();
}

int Nesting::enter(const Token& token) {
  const auto open = [this] { return depth_++; };
  const auto close = [this] { return depth_ = std::max(0, depth_ - 1); };
  switch (token.kind) {
    case TokenKind::begin_group:
      return open();
    case TokenKind::end_group:
      return close();
    case TokenKind::control:
      if (token.text == "begin") return open();
      if (token.text == "end") return close();
      if (braces_only_) return depth_;
      if (is_one_of(token.text, {"{", "lbrace", "lvert", "lVert"})) return open();
      if (is_one_of(token.text, {"}", "rbrace", "rvert", "rVert"})) return close();
      return depth_;
    case TokenKind::other:
      if (braces_only_) return depth_;
      if (token.text == "(" || token.text == "[") return open();
      if (token.text == ")" || token.text == "]") return close();
      return depth_;
    default:
      return depth_;
  }
}

namespace {

/// A letter that is written with words (`quantity_words.h`).
bool is_quantity_words(const Token& token) {
  return token.kind == TokenKind::letter && token.text.size() > 1 && is_letter(token.text.front());
}

}  // namespace

Span span_of(TokenView tokens) {
  Span span = tokens.empty() ? Span{} : tokens.front().span;
  for (const Token& token : tokens) span = cover(span, token.span);
  return span;
}

TokenView trim(TokenView tokens) {
  while (!tokens.empty() && is_blank(tokens.front())) tokens = tokens.subspan(1);
  while (!tokens.empty() && is_blank(tokens.back())) tokens = tokens.first(tokens.size() - 1);
  return tokens;
}

std::string text_of(TokenView tokens) {
  std::string text;
  bool after_word = false;  // a control word must not run into the letter after it
  for (const Token& token : trim(tokens)) {
    if (is_blank(token)) {
      if (!text.empty() && text.back() != ' ') text += ' ';
      after_word = false;
      continue;
    }
    const bool words = is_quantity_words(token);
    if (after_word && token.kind == TokenKind::letter && !words) text += ' ';
    if (token.kind == TokenKind::control) text += '\\';
    if (token.kind == TokenKind::parameter) text += '#';
    text += words ? letter_of(token) : std::string(token.text);
    after_word = token.kind == TokenKind::control && token.text.size() > 1;
  }
  return text;
}

bool are_columns(TokenView tokens) {
  static constexpr std::string_view signs = "clrtb|[]{}@ ";
  return std::ranges::all_of(tokens, [](const Token& token) {
    return token.text.size() == 1 && signs.find(token.text) != std::string_view::npos;
  });
}

}  // namespace rigor
