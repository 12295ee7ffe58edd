// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/split/beside.h"

#include <algorithm>

#include "base/among.h"
#include "base/ascii.h"
#include "latex/split/blocks.h"
#include "latex/token/accounting.h"
#include "latex/token/differential.h"
#include "latex/token/remarks.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

constexpr std::size_t longest_list = 40;  // of tokens that are looked at

bool is_swallowing(Remark kind) { return kind == Remark::no_sum || kind == Remark::cyclic; }

bool is_visible_space(const Token& token) {
  return is_sign(token, "~") || is_control(token, " ") || is_control(token, "enspace");
}

/// `\sin~x`: what comes after the space belongs to the sign before it.
bool awaits_argument(const Token& token) {
  return token.kind == TokenKind::control && letter_of(token).empty();
}

/// A symbol with its accents, without its scripts.
std::string bare_letter(TokenView symbol) {
  Nesting nesting(false);
  std::size_t end = 0;
  while (end < symbol.size()) {
    const bool script = is_script(symbol[end]);
    if (nesting.enter(symbol[end]) == 0 && script) break;
    ++end;
  }
  std::string text;
  for (const Token& token : symbol.first(end)) {
    if (!is_blank(token) && token.kind != TokenKind::begin_group && token.kind != TokenKind::end_group)
      text += text_of({&token, 1});
  }
  return text;
}

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

std::set<std::string> symbols_in(TokenView tokens) {
  std::set<std::string> symbols;
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    if (is_words(tokens[at])) {
      at = argument_at(tokens, at + 1).next - 1;
    } else if (const std::string letter = letter_of(tokens[at]); !letter.empty()) {
      symbols.insert(letter.size() > 1 ? letter.substr(1) : letter);  // `alpha` of α
    }
  }
  return symbols;
}

bool lists_symbols(TokenView tokens) {
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    const Token& token = tokens[at];
    if (is_words(token)) {
      const Argument words = argument_at(tokens, at + 1);
      if (remark_of(text_of(words.content)) != Remark::connective) return false;
      at = words.next - 1;
      continue;
    }
    const bool symbol = !letter_of(token).empty() || token.kind == TokenKind::digit || style_of(token) ||
                        token.kind == TokenKind::subscript || is_sign(token, "'");
    if (!symbol && !is_layout(token) && !is_sign_of(token, ",.")) return false;
  }
  return true;
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
  if (!is_sign_of(tokens[at], "([")) return at;
  const std::size_t inside = first_significant(tokens, at + 1);
  if (inside >= tokens.size() || !is_words(tokens[inside])) return at;
  const std::size_t end = bracket_end(tokens, at);
  return is_swallowing(remark_of(spoken(tokens.subspan(at, end - at)))) ? end : at;
}

Beside behind_space(TokenView before, TokenView tokens, std::size_t at) {
  before = trim(before);
  if (before.empty() || !is_visible_space(before.back())) return Beside::goes_on;
  const std::size_t end = symbol_end(tokens, at);
  const std::size_t behind = first_significant(tokens, end);
  if (end == at || behind >= tokens.size() || !relation_kind(tokens[behind])) return Beside::goes_on;
  std::size_t last = before.size();
  while (last > 0 && (is_blank(before[last - 1]) || is_spacing(before[last - 1]))) --last;
  before = before.first(last);
  if (before.empty() || ends_open(before) || awaits_argument(before.back())) return Beside::goes_on;
  const std::size_t first = first_significant(before, 0);
  const std::size_t left = symbol_end(before, first);
  const std::size_t relation = first_significant(before, left);
  const bool again =
      left != first && relation < before.size() && relation_kind(before[relation]) &&
      bare_letter(before.subspan(first, left - first)) == bare_letter(tokens.subspan(at, end - at));
  return again ? Beside::begins : Beside::unclear;
}

bool is_equation_number(TokenView block) {
  block = trim(block);
  if (block.size() < 3 || block.size() > 10 || !is_sign(block.front(), "(") || !is_sign(block.back(), ")"))
    return false;
  bool digit = false;
  for (const Token& token : block.subspan(1, block.size() - 2)) {
    digit = digit || token.kind == TokenKind::digit;
    const bool fits = token.kind == TokenKind::digit || is_sign_of(token, ".'-*") ||
                      (token.kind == TokenKind::letter && token.text.size() == 1);
    if (!fits) return false;
  }
  return digit;
}

bool is_index_range(TokenView block) {
  std::string text;
  for (const Token& token : block) {
    if (!is_blank(token) && !is_spacing(token)) text += text_of({&token, 1});
  }
  if (!text.empty() && text.front() == '(' && text.back() == ')') text = text.substr(1, text.size() - 2);
  const auto equal = text.find('=');
  if (equal == std::string::npos || equal == 0) return false;
  for (std::size_t i = 0; i < equal; ++i) {
    if (i % 2 == 0 ? !is_small_letter(text[i]) : text[i] != ',') return false;
  }
  const std::string range = text.substr(equal + 1);
  return range == "1,2,3" ||
         is_one_of(range, {"1,2,3.", "1\\ldots3", "1,\\ldots,3", "1,\\dots,3", "x,y,z", "x,y,z."});
}

bool is_ornament(TokenView block) {
  return std::ranges::all_of(block, [](const Token& token) {
    return is_blank(token) || is_spacing(token) || is_sign_of(token, ".,;:") ||
           is_control_of(token, {"checkmark", "blacksquare", "qed", "Box", "square", "therefore", "because"});
  });
}

bool lists_values(TokenView block) {
  block = without_stop(block);
  Nesting nesting(false);
  std::size_t relation = block.size();
  bool goes_on = false;
  bool comma = false;
  for (std::size_t at = 0; at < block.size(); ++at) {
    if (nesting.enter(block[at]) != 0) continue;
    if (relation_kind(block[at]) || is_control(block[at], "in")) {
      if (relation != block.size()) return false;
      relation = at;
    }
    if (relation == block.size()) continue;
    goes_on = goes_on || is_control_of(block[at], {"dots", "ldots", "cdots", "dotsc"});
    comma = comma || is_sign(block[at], ",");
  }
  if (relation == block.size() || trim(block.first(relation)).empty() ||
      !lists_symbols(block.first(relation)))
    return false;
  return is_control(block[relation], "in") || (is_sign(block[relation], "=") && goes_on && comma);
}

TokenView without_stop(TokenView block) {
  block = trim(block);
  while (!block.empty() && (is_sign_of(block.back(), ".,;:") || is_spacing(block.back())))
    block = trim(block.first(block.size() - 1));
  return block;
}

}  // namespace rigor
