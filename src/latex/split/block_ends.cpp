// SPDX-License-Identifier: GPL-3.0-or-later
// Questions about a stretch of a display: is there a relation, must more follow?
#include <algorithm>

#include "base/ascii.h"
#include "latex/split/blocks.h"
#include "latex/split/chain.h"

namespace rigor {

std::size_t first_significant(TokenView tokens, std::size_t at) {
  while (at < tokens.size()) {
    const std::size_t behind = skip_empty_group(tokens, at);
    if (behind == at && !is_blank(tokens[at]) && !is_spacing(tokens[at])) return at;
    at = std::max(at + 1, behind);
  }
  return at;
}

bool is_stacked_relation(TokenView tokens, std::size_t at) {
  if (at >= tokens.size()) return false;
  if (!is_control_of(tokens[at], {"overset", "stackrel", "underset"})) return false;
  const Argument above = argument_at(tokens, at + 1);
  const TokenView below = trim(argument_at(tokens, above.next).content);
  return below.size() == 1 && relation_kind(below.front()).has_value() &&
         text_of(above.content).find("leftrightarrow") == std::string::npos;
}

bool has_relation(TokenView tokens) {
  Nesting nesting(false);
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    if (nesting.enter(tokens[at]) != 0 || is_script_argument(tokens, at)) continue;
    const auto kind = relation_kind(tokens[at]);
    if ((kind && *kind != RelationKind::implies) || is_stacked_relation(tokens, at)) return true;
  }
  return false;
}

bool relates_index_letters(TokenView block) {
  bool relation = false;
  bool only_equal = true;
  bool index_letter = false;
  bool index_letters_only = true;
  for (const Token& token : block) {
    if (is_blank(token) || is_spacing(token) || is_sign_of(token, "(),")) continue;
    if (const auto kind = relation_kind(token)) {
      relation = true;
      only_equal = only_equal && kind == RelationKind::equal;
      continue;
    }
    const bool letter = token.kind == TokenKind::letter && token.text.size() == 1;
    if (!letter && token.kind != TokenKind::digit) return false;
    const bool strong = letter && token.text[0] >= 'i' && token.text[0] <= 'n';
    index_letter = index_letter || strong;
    index_letters_only = index_letters_only && (strong || !letter);
  }
  return relation && (only_equal ? index_letter && index_letters_only : true);
}

bool ends_open(TokenView tokens) {
  tokens = without_empty_end(tokens);
  while (!tokens.empty() && (is_spacing(tokens.back()) || is_wide_space(tokens.back())))
    tokens = trim(tokens.first(tokens.size() - 1));
  if (tokens.empty()) return false;
  if (is_script_argument(tokens, tokens.size() - 1)) return false;
  const Token& last = tokens.back();
  return relation_kind(last).has_value() || is_sign_of(last, "+-") || factor_joint(last) != Joint::none;
}

}  // namespace rigor
