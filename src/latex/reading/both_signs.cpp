// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/reading/both_signs.h"

#include <algorithm>
#include <optional>

#include "latex/token/tokens.h"

namespace rigor {
namespace {

bool is_double_sign(const Token& token) { return is_control(token, "pm") || is_control(token, "mp"); }

bool has_double_sign(const WrittenSide& side) { return std::ranges::any_of(side.tokens, is_double_sign); }

/// Where `{1,2}` or `{1/2}` stands as a subscript: from its `{` on.
struct PairOfLabels {
  std::size_t first = 0;
  std::size_t second = 0;
};

std::optional<PairOfLabels> pair_of_labels(TokenView tokens, std::size_t sub) {
  if (tokens[sub].kind != TokenKind::subscript || sub + 1 >= tokens.size() ||
      tokens[sub + 1].kind != TokenKind::begin_group)
    return std::nullopt;
  const auto is_label = [&](std::size_t at) {
    return at < tokens.size() && tokens[at].kind == TokenKind::digit && tokens[at].text.size() == 1;
  };
  const std::size_t first = skip_blank(tokens, sub + 2);
  const std::size_t between = is_label(first) ? skip_blank(tokens, first + 1) : tokens.size();
  if (between >= tokens.size() || !(is_sign(tokens[between], ",") || is_sign(tokens[between], "/")))
    return std::nullopt;
  const std::size_t second = skip_blank(tokens, between + 1);
  const std::size_t end = is_label(second) ? skip_blank(tokens, second + 1) : tokens.size();
  if (end >= tokens.size() || tokens[end].kind != TokenKind::end_group ||
      tokens[first].text == tokens[second].text)
    return std::nullopt;
  return PairOfLabels{first, second};
}

bool names_a_pair(const WrittenSide& side) {
  for (std::size_t k = 0; k < side.tokens.size(); ++k) {
    if (pair_of_labels(side.tokens, k)) return true;
  }
  return false;
}

/// `T_{1,2} = 5.2 \pm 0.1`: decimals and units are of what was measured.
bool may_be_measured(const WrittenSide& side) {
  return std::ranges::any_of(side.tokens, [](const Token& token) {
    return is_sign(token, ".") || is_control_of(token, {"mathrm", "text", "SI", "qty", "unit", "si"});
  });
}

/// One label of each pair.
Tokens with_one_label(TokenView tokens, bool first) {
  Tokens kept;
  for (std::size_t k = 0; k < tokens.size(); ++k) {
    kept.push_back(tokens[k]);
    const auto pair = pair_of_labels(tokens, k);
    if (!pair) continue;
    kept.push_back(tokens[k + 1]);
    kept.push_back(tokens[first ? pair->first : pair->second]);
    k = pair->second;
  }
  return kept;
}

}  // namespace

bool is_two_statements(const WrittenChain& chain) {
  if (chain.relations.empty()) return false;
  if (std::ranges::all_of(chain.sides, has_double_sign)) return true;
  return std::ranges::any_of(chain.sides, has_double_sign) &&
         std::ranges::all_of(chain.sides, [](const WrittenSide& side) {
           return !may_be_measured(side) && (has_double_sign(side) || names_a_pair(side));
         });
}

WrittenChain with_signs(WrittenChain chain, bool upper) {
  for (WrittenSide& side : chain.sides) {
    for (Token& token : side.tokens) {
      if (!is_double_sign(token)) continue;
      token.text = is_control(token, "pm") == upper ? "+" : "-";
      token.kind = TokenKind::other;
    }
    side.tokens = with_one_label(side.tokens, upper);
  }
  for (WrittenChain& condition : chain.assumed) condition = with_signs(std::move(condition), upper);
  return chain;
}

}  // namespace rigor
