// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/macro/macro_stream.h"

namespace rigor {

std::optional<Token> MacroStream::peek() {
  while (layers_.size() > 1 && layers_.back().at == layers_.back().tokens().size()) layers_.pop_back();
  const Layer& layer = layers_.back();
  if (layer.at == layer.tokens().size()) return std::nullopt;
  return layer.tokens()[layer.at];
}

std::optional<Token> MacroStream::peek(std::size_t behind) const {
  for (auto layer = layers_.rbegin(); layer != layers_.rend(); ++layer) {
    const TokenView left = layer->tokens().subspan(layer->at);
    if (behind < left.size()) return left[behind];
    behind -= left.size();
  }
  return std::nullopt;
}

std::optional<Token> MacroStream::take() {
  const auto token = peek();
  if (token) ++layers_.back().at;
  return token;
}

bool MacroStream::take_sign(std::string_view sign) {
  const auto token = peek();
  if (!token || !is_sign(*token, sign)) return false;
  take();
  return true;
}

void MacroStream::skip_spaces() {
  for (auto token = peek(); token && token->kind == TokenKind::space; token = peek()) take();
}

std::optional<TakenArgument> MacroStream::take_argument() {
  skip_spaces();
  const auto first = peek();
  if (!first || first->kind == TokenKind::paragraph || first->kind == TokenKind::end_group)
    return std::nullopt;
  take();
  if (first->kind != TokenKind::begin_group) return TakenArgument{{*first}, first->span};
  TakenArgument argument{{}, first->span};
  int depth = 1;
  while (const auto token = take()) {
    if (token->kind == TokenKind::begin_group) ++depth;
    if (token->kind == TokenKind::end_group && --depth == 0) {
      argument.span = cover(argument.span, token->span);
      return argument;
    }
    argument.tokens.push_back(*token);
  }
  return std::nullopt;
}

std::optional<TakenArgument> MacroStream::take_optional() {
  skip_spaces();
  TakenArgument argument{{}, take()->span};
  int depth = 0;
  while (const auto token = take()) {
    if (token->kind == TokenKind::begin_group) ++depth;
    if (token->kind == TokenKind::end_group && --depth < 0) return std::nullopt;
    if (depth == 0 && is_sign(*token, "]")) {
      argument.span = cover(argument.span, token->span);
      return argument;
    }
    argument.tokens.push_back(*token);
  }
  return std::nullopt;
}

}  // namespace rigor
