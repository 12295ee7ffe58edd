// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/parse/box_operator.h"

#include <array>
#include <string_view>

#include "base/among.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

bool is_box(const Token& token) { return is_control(token, "square") || is_control(token, "Box"); }

/// What comes after a factor and is multiplied by it, or what an operator acts on.
bool starts_operand(TokenView tokens, std::size_t at) {
  static constexpr auto closing = std::to_array<std::string_view>(
      {"right", "rangle", "rvert", "rVert", "middle", "bigr", "Bigr", "biggr", "Biggr"});
  if (at >= tokens.size()) return false;
  const Token& token = tokens[at];
  switch (token.kind) {
    case TokenKind::letter:
    case TokenKind::begin_group:
      return true;
    case TokenKind::other:
      return is_sign_of(token, "([");
    case TokenKind::control:
      return !is_spacing(token) && !is_words(token) && factor_joint(token) == Joint::none &&
             !is_sum_sign(token) && !is_one_of(token.text, closing);
    default:
      return false;
  }
}

/// After `^2`, `^{2}` and the like at `at`.
std::size_t behind_power(TokenView tokens, std::size_t at) {
  const std::size_t script = skip_blank(tokens, at);
  if (!is_kind_at(tokens, script, TokenKind::superscript)) return at;
  return argument_at(tokens, script + 1).next;
}

/// A term of the sum is a box, with or without something before it.
bool has_box_term(TokenView sum) {
  int depth = 0;
  for (std::size_t k = 0; k < sum.size(); ++k) {
    if (sum[k].kind == TokenKind::begin_group) ++depth;
    if (sum[k].kind == TokenKind::end_group) --depth;
    if (depth != 0 || !is_box(sum[k])) continue;
    const std::size_t behind = skip_blank(sum, behind_power(sum, k + 1));
    if (behind == sum.size() || is_sum_sign(sum[behind]) || is_sign_of(sum[behind], ")]") ||
        is_control(sum[behind], "right"))
      return true;
  }
  return false;
}

}  // namespace

bool is_box_operator(TokenView tokens, std::size_t begin, std::size_t end) {
  const Token& first = tokens[begin];
  if (!starts_operand(tokens, skip_blank(tokens, end))) return false;
  if (is_box(first)) return behind_power(tokens, begin + 1) == end;
  const bool bracket = is_sign_of(first, "([") || is_control(first, "left");
  return bracket && has_box_term(tokens.subspan(begin, end - begin));
}

}  // namespace rigor
