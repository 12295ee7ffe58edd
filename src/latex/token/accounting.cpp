// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/token/accounting.h"

#include <algorithm>

#include "latex/token/vocabulary.h"

namespace rigor {

bool is_layout(const Token& token) {
  switch (token.kind) {
    case TokenKind::begin_group:
    case TokenKind::end_group:
    case TokenKind::align:
      return true;
    default:
      return is_spacing(token) || is_wide_space(token) || is_control(token, "\\") || is_control(token, "cr");
  }
}

void TokenUses::mark(TokenView tokens, TokenUse use) {
  for (const Token& token : tokens) {
    if (token.place == 0 || token.place > uses_.size()) continue;
    TokenUse& known = uses_[token.place - 1];
    if (known != TokenUse::condition) known = use;
  }
}

TokenUse TokenUses::of(const Token& token) const {
  if (token.place == 0 || token.place > uses_.size()) return TokenUse::layout;
  return uses_[token.place - 1];
}

const Token* TokenUses::left_over(TokenView tokens) const {
  const auto found = std::ranges::find_if(
      tokens, [this](const Token& token) { return of(token) == TokenUse::none && !is_layout(token); });
  return found == tokens.end() ? nullptr : &*found;
}

Tokens counted(TokenView tokens) {
  Tokens copy(tokens.begin(), tokens.end());
  std::uint32_t place = 0;
  for (Token& token : copy) token.place = ++place;
  return copy;
}

void SideAccount::read(TokenView tokens) {
  if (tokens.empty() || tokens.data() < side_.data() || tokens.data() >= side_.data() + side_.size()) return;
  const auto begin = static_cast<std::size_t>(tokens.data() - side_.data());
  std::fill_n(read_.begin() + static_cast<std::ptrdiff_t>(begin),
              std::min(tokens.size(), side_.size() - begin), true);
}

const Token* SideAccount::left_over() const {
  for (std::size_t at = 0; at < side_.size(); ++at) {
    if (!read_[at] && !is_layout(side_[at])) return &side_[at];
  }
  return nullptr;
}

}  // namespace rigor
