// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/token/state_places.h"

#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

bool is_state_bar(const Token& token) { return is_sign(token, "|") || is_control_of(token, {"vert", "mid"}); }

bool is_any_bar(const Token& token) {
  return is_state_bar(token) || is_control_of(token, {"lvert", "rvert", "lVert", "rVert", "|", "Vert"});
}

std::size_t skip_spaces(TokenView tokens, std::size_t at) {
  while (at < tokens.size() && (is_blank(tokens[at]) || is_spacing(tokens[at]))) ++at;
  return at;
}

}  // namespace

StateAngles state_angles(TokenView tokens, std::size_t open) {
  StateAngles found{{}, tokens.size()};
  Nesting nesting(false);
  int inside = 0;
  for (std::size_t at = open + 1; at < tokens.size(); ++at) {
    if (nesting.enter(tokens[at]) != 0) continue;
    if (is_control(tokens[at], "langle") && ++inside > deepest_states) break;
    if (is_control(tokens[at], "rangle") && --inside < 0) {
      found.close = at;
      break;
    }
    if (inside == 0 && is_state_bar(tokens[at])) found.bars.push_back(at);
  }
  const bool at_once = !found.bars.empty() && found.bars[0] == skip_blank(tokens, open + 1);
  if (at_once) found.bars.clear();
  if (found.close < tokens.size() && found.bars.size() > 1) {  // `|0\rangle\langle 1| + |1\rangle\langle 0|`
    const TokenView middle = trim(tokens.subspan(found.bars[0] + 1, found.bars.back() - found.bars[0] - 1));
    const bool goes_on = is_control_at(tokens, skip_spaces(tokens, found.close + 1), "langle");
    const bool sum =
        !middle.empty() && (is_sum_sign(middle.back()) || (is_sum_sign(middle.front()) && goes_on));
    if (sum) found.close = tokens.size();
  }
  if (found.close == tokens.size() && found.bars.size() > 1) found.bars.resize(1);
  return found;
}

std::vector<std::size_t> bars_of_states(TokenView content) {
  std::vector<std::size_t> bars;
  Nesting nesting(false);
  int inside = 0;
  for (std::size_t at = 0; at < content.size(); ++at) {
    if (nesting.enter(content[at]) != 0) continue;
    if (is_control(content[at], "langle")) ++inside;
    if (is_control(content[at], "rangle")) --inside;
    if (inside == 0 && is_state_bar(content[at])) bars.push_back(at);
  }
  return bars;
}

std::size_t behind_ket(TokenView tokens, std::size_t bar) {
  if (bar >= tokens.size() || !is_state_bar(tokens[bar])) return bar;
  Nesting nesting(false);
  for (std::size_t at = bar + 1; at < tokens.size(); ++at) {
    if (nesting.enter(tokens[at]) != 0) continue;
    if (is_any_bar(tokens[at]) || is_control(tokens[at], "langle") || relation_kind(tokens[at])) return bar;
    if (is_control(tokens[at], "rangle")) return at + 1;
  }
  return bar;
}

std::size_t behind_states(TokenView tokens, std::size_t at) {
  if (at < tokens.size() && is_control(tokens[at], "langle")) {
    const StateAngles angles = state_angles(tokens, at);
    return angles.close < tokens.size() ? angles.close + 1 : at;
  }
  return behind_ket(tokens, at);
}

bool is_bar_of_one_state(TokenView tokens, std::size_t bar) {
  if (bar >= tokens.size() || !is_any_bar(tokens[bar])) return false;
  const auto is_end = [](const Token& token) {
    return is_any_bar(token) || is_control_of(token, {"middle", "\\", "cr"}) ||
           token.kind == TokenKind::align;
  };
  for (std::size_t at = bar + 1; at < tokens.size(); ++at) {
    if (is_control(tokens[at], "rangle")) return true;
    if (is_sign(tokens[at], ">") && at > 0 && is_bracket_size(tokens[at - 1])) return true;
    if (is_end(tokens[at]) || is_control(tokens[at], "langle") || relation_kind(tokens[at])) break;
  }
  for (std::size_t at = bar; at-- > 0;) {
    if (is_control(tokens[at], "langle")) return true;
    if (is_sign(tokens[at], "<") && at > 0 && is_bracket_size(tokens[at - 1])) return true;
    if (is_end(tokens[at]) || is_control(tokens[at], "rangle") || relation_kind(tokens[at])) break;
  }
  return false;
}

}  // namespace rigor
