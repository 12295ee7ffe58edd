// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/split/chain.h"

#include <algorithm>
#include <optional>

#include "base/among.h"
#include "latex/split/blocks.h"
#include "latex/token/cover_tokens.h"
#include "latex/token/remarks.h"

namespace rigor {
namespace {

/// `...` leaves something out; a fourth dot is a full stop.
bool ends_with_three_dots(TokenView tokens) {
  const auto is_other = [](const Token& token) { return !is_sign(token, "."); };
  const auto last_other = std::find_if(tokens.rbegin(), tokens.rend(), is_other);
  return last_other - tokens.rbegin() == 3;
}

TokenView without_punctuation(TokenView tokens) {
  tokens = without_empty_end(tokens);
  while (!tokens.empty() && (is_spacing(tokens.back()) || is_sign_of(tokens.back(), ".,;:"))) {
    if (ends_with_three_dots(tokens)) break;
    tokens = trim(tokens.first(tokens.size() - 1));
  }
  return tokens.subspan(first_significant(tokens, 0));
}

/// `3.14159` of `3.14159...` and `3.14159\dots`: a decimal whose digits go on; nothing for other sides.
std::optional<TokenView> decimal_that_goes_on(TokenView side) {
  const bool control = !side.empty() && is_control_of(side.back(), {"dots", "ldots", "dotsc", "cdots"});
  if (!control && !ends_with_three_dots(side)) return std::nullopt;
  const TokenView before = trim(side.first(side.size() - (control ? 1 : 3)));
  std::size_t begin = before.size();
  const auto is_part = [](const Token& token) {
    return token.kind == TokenKind::digit || is_sign(token, ".");
  };
  while (begin > 0 && is_part(before[begin - 1])) --begin;
  const TokenView number = before.subspan(begin);
  const auto points = std::ranges::count_if(number, [](const Token& token) { return is_sign(token, "."); });
  const bool decimal = points == 1 && number.back().kind == TokenKind::digit;
  return decimal ? std::optional(before) : std::nullopt;
}

/// The relation at `at`, and the place after it.
struct RelationAt {
  WrittenRelation relation;
  std::size_t next;
};

/// What is written on a relation.
enum class Mark : std::uint8_t { reference, defines, demanded, unread };

/// `(3)`, `\eqref{eq:1}`, `\text{def}`, `!`; the words of remarks.
Mark mark_of(TokenView mark) {
  mark = trim(mark);
  const std::string text = text_of(mark);
  if (text == "!" || text == "\\text{!}") return Mark::demanded;
  if (text == "\\triangle" || text == "\\Delta") return Mark::defines;
  if (!mark.empty() && mark.front().kind == TokenKind::control &&
      (is_words(mark[0]) || is_control(mark[0], "mathrm") || is_control(mark[0], "rm"))) {
    const Argument words = argument_at(mark, 1);
    const std::string said = text_of(is_control(mark[0], "rm") ? mark.subspan(1) : words.content);
    if (is_one_of(said, {"def", "def.", "Def", "Def.", "definition"})) return Mark::defines;
    const bool all = words.next == mark.size() && !is_control(mark[0], "rm");
    return all && remark_of(said) == Remark::remark ? Mark::reference : Mark::unread;
  }
  if (!mark.empty() && (is_control(mark[0], "eqref") || is_control(mark[0], "ref")))
    return argument_at(mark, 1).next == mark.size() ? Mark::reference : Mark::unread;
  if (text == "def") return Mark::defines;
  const bool number = text.find_first_not_of("0123456789().ab") == std::string::npos;
  return number ? Mark::reference : Mark::unread;
}

std::optional<RelationAt> relation_at(TokenView tokens, std::size_t at) {
  const Token& token = tokens[at];
  if (is_sign(token, ":") && at + 1 < tokens.size() && is_sign(tokens[at + 1], "=")) {
    return RelationAt{{RelationKind::defines, cover(token.span, tokens[at + 1].span), ":="}, at + 2};
  }
  if (is_stacked_relation(tokens, at)) {
    const Argument above = argument_at(tokens, at + 1);
    const Argument below = argument_at(tokens, above.next);
    RelationKind kind = relation_kind(trim(below.content).front()).value_or(RelationKind::equal);
    const Mark mark = mark_of(above.content);
    if (mark == Mark::unread) kind = RelationKind::other;
    if (mark == Mark::demanded) kind = RelationKind::demanded;
    if (mark == Mark::defines) kind = RelationKind::defines;
    return RelationAt{{kind, cover(token.span, below.content), text_of(tokens.subspan(at, below.next - at))},
                      below.next};
  }
  if (is_control(token, "not") && at + 1 < tokens.size() && relation_kind(tokens[at + 1])) {
    const bool unequal = relation_kind(tokens[at + 1]) == RelationKind::equal;
    return RelationAt{{unequal ? RelationKind::unequal : RelationKind::other,
                       cover(token.span, tokens[at + 1].span), text_of(tokens.subspan(at, 2))},
                      at + 2};
  }
  if (const auto kind = relation_kind(token))
    return RelationAt{{*kind, token.span, text_of({&token, 1})}, at + 1};
  return std::nullopt;
}

}  // namespace

TokenView without_empty_end(TokenView tokens) {
  tokens = trim(tokens);
  while (tokens.size() > 1 && tokens.back().kind == TokenKind::end_group) {
    const TokenView open = trim(tokens.first(tokens.size() - 1));
    const bool empty = !open.empty() && open.back().kind == TokenKind::begin_group &&
                       (open.size() == 1 || (open[open.size() - 2].kind != TokenKind::control &&
                                             open[open.size() - 2].kind != TokenKind::end_group &&
                                             !is_script_argument(open, open.size() - 1)));
    if (!empty) break;
    tokens = trim(open.first(open.size() - 1));
  }
  return tokens;
}

WrittenChain chain_of(TokenView tokens, TokenUses& uses) {
  WrittenChain chain;
  Nesting nesting(false);
  std::size_t begin = 0;
  const auto finish_side = [&](std::size_t end) {
    TokenView side = without_punctuation(tokens.subspan(begin, end - begin));
    if (const auto decimal = decimal_that_goes_on(side)) {
      side = *decimal;
      chain.digits_go_on = true;
    }
    uses.mark(tokens.subspan(begin, end - begin), TokenUse::layout);  // a full stop at the end
    uses.mark(side, TokenUse::side);
    Span span = span_of(side);
    if (side.empty() && !chain.relations.empty()) {
      span = chain.relations.back().span;
      span.begin = span.end;
    } else if (side.empty() && !tokens.empty()) {
      span = tokens.front().span;
      span.end = span.begin;
    }
    chain.sides.push_back({Tokens(side.begin(), side.end()), span});
  };
  for (std::size_t at = 0; at < tokens.size();) {
    const int depth = nesting.enter(tokens[at]);
    const auto found = depth == 0 && !is_script_argument(tokens, at) ? relation_at(tokens, at) : std::nullopt;
    if (!found) {
      ++at;
      continue;
    }
    finish_side(at);
    chain.relations.push_back(found->relation);
    uses.mark(tokens.subspan(at, found->next - at), TokenUse::relation);
    at = begin = found->next;
  }
  finish_side(tokens.size());
  if (chain.sides.front().tokens.empty() && !chain.relations.empty()) {
    chain.sides.front().span = chain.relations.front().span;
    chain.sides.front().span.end = chain.sides.front().span.begin;
  }
  chain.span = cover(chain.sides.front().span, chain.sides.back().span);
  for (const WrittenSide& side : chain.sides) chain.span = cover(chain.span, side.span);
  return chain;
}

}  // namespace rigor
