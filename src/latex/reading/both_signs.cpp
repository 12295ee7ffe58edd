// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/reading/both_signs.h"

#include <algorithm>

#include "latex/token/tokens.h"

namespace rigor {
namespace {

bool is_double_sign(const Token& token) { return is_control(token, "pm") || is_control(token, "mp"); }

}  // namespace

bool is_two_statements(const WrittenChain& chain) {
  return !chain.relations.empty() && std::ranges::all_of(chain.sides, [](const WrittenSide& side) {
    return std::ranges::any_of(side.tokens, is_double_sign);
  });
}

WrittenChain with_signs(WrittenChain chain, bool upper) {
  for (WrittenSide& side : chain.sides) {
    for (Token& token : side.tokens) {
      if (!is_double_sign(token)) continue;
      token.text = is_control(token, "pm") == upper ? "+" : "-";
      token.kind = TokenKind::other;
    }
  }
  for (WrittenChain& condition : chain.assumed) condition = with_signs(std::move(condition), upper);
  return chain;
}

}  // namespace rigor
