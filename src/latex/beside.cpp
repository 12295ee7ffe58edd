// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/beside.h"

#include <algorithm>

#include "latex/blocks.h"
#include "latex/differential.h"
#include "latex/remarks.h"

namespace rigor {
namespace {

constexpr std::size_t longest_list = 40;  // of tokens that are looked at

bool is_swallowing(Remark kind) { return kind == Remark::no_sum || kind == Remark::cyclic; }

}  // namespace

std::string spoken(TokenView tokens) {
  std::string words;
  for (std::size_t at = 0; at < tokens.size();) {
    const bool text = is_words(tokens[at]) || is_control(tokens[at], "mathrm");
    const Argument argument = text ? argument_at(tokens, at + 1) : Argument{tokens.subspan(at, 1), at + 1};
    words += text_of(argument.content) + " ";
    at = argument.next;
  }
  return words;
}

std::size_t remark_end(TokenView tokens, const Argument& words) {
  const Remark kind = remark_of(text_of(words.content));
  if (!is_swallowing(kind)) return words.next;
  std::size_t end = words.next;
  while (end < tokens.size() && end - words.next < longest_list && !is_wide_space(tokens[end]) &&
         !is_words(tokens[end]) && !relation_kind(tokens[end]))
    ++end;
  if (end < tokens.size() && relation_kind(tokens[end])) return words.next;
  const std::string all =
      text_of(words.content) + " " + text_of(tokens.subspan(words.next, end - words.next));
  return remark_of(all) == kind ? end : words.next;
}

std::size_t bracketed_remark_end(TokenView tokens, std::size_t at) {
  if (!is_sign(tokens[at], "(") && !is_sign(tokens[at], "[")) return at;
  const std::size_t inside = first_significant(tokens, at + 1);
  if (inside >= tokens.size() || !is_words(tokens[inside])) return at;
  const std::size_t end = bracket_end(tokens, at);
  return is_swallowing(remark_of(spoken(tokens.subspan(at, end - at)))) ? end : at;
}

bool begins_next_dotted(TokenView before, TokenView tokens, std::size_t at) {
  if (dots_of(tokens[at]) == 0 || before.empty()) return false;
  const Token& space = before.back();
  if (!is_sign(space, "~") && !is_control(space, " ") && !is_control(space, "enspace")) return false;
  const std::size_t first = first_significant(before, 0);
  if (first >= before.size() || before[first].text != tokens[at].text) return false;
  const auto letter = [](TokenView from, std::size_t control) {
    const TokenView rest = from.subspan(control + 1);
    return text_of(argument_at(rest.first(std::min(rest.size(), longest_list)), 0).content);
  };
  if (letter(before, first) != letter(tokens, at)) return false;
  const std::size_t behind = first_significant(tokens, symbol_end(tokens, at));
  return behind < tokens.size() && relation_kind(tokens[behind]) == RelationKind::equal;
}

}  // namespace rigor
