// SPDX-License-Identifier: GPL-3.0-or-later
// Braces that act as brackets, which no reader sees: both readings count. And brackets that group nothing.
#include <fmt/format.h>

#include <utility>

#include "base/ascii.h"
#include "latex/parse/parser.h"
#include "latex/parse/unseen_braces.h"

namespace rigor {

bool Parser::lifts_braces(const Cursor& cursor) {
  if (!groups_unseen(cursor.tokens, cursor.at)) return false;
  std::size_t begin = cursor.at;
  while (begin > 0 && is_blank(cursor.tokens[begin - 1])) --begin;
  const bool shown = begin > 0 && cursor.tokens[begin - 1].kind != TokenKind::end_group;
  return lifts(cursor, shown ? begin - 1 : cursor.at);
}

SyntaxId Parser::stacked_powers(Span span) {
  return opaque(span,
                "braces are invisible in print: this can be a power of a power, or one power of two signs",
                DiagnosticKind::ambiguous_reading, {"put brackets around the first power"});
}

bool Parser::lifts_braces_of_argument(const Cursor& cursor, std::size_t begin) {
  return holds_unseen_sum(cursor.tokens, cursor.at) && lifts(cursor, begin);
}

/// `begin`: where what comes before the braces begins. A blank takes the place of a brace, so that no token
/// moves.
bool Parser::lifts(const Cursor& cursor, std::size_t begin) {
  const Argument group = argument_at(cursor.tokens, cursor.at);
  const std::size_t close = group.next - 1;
  const bool asked = std::exchange(asked_, &cursor.token()) == &cursor.token();
  if (asked || side_.empty() || cursor.tokens[close].kind != TokenKind::end_group) return false;
  std::size_t end = skip_blank(cursor.tokens, group.next);
  const bool script = end < cursor.tokens.size() && (cursor.tokens[end].kind == TokenKind::superscript ||
                                                     cursor.tokens[end].kind == TokenKind::subscript);
  const bool operand = end < cursor.tokens.size() && (cursor.tokens[end].kind == TokenKind::letter ||
                                                      cursor.tokens[end].kind == TokenKind::digit);
  end = script ? script_argument_at(cursor.tokens, end + 1).next : operand ? end + 1 : group.next;
  const std::string before = text_of(cursor.tokens.subspan(begin, cursor.at - begin));
  const std::string_view blank = before.empty() ? "" : " ";
  const std::string inside = text_of(group.content);
  const std::string behind = text_of(cursor.tokens.subspan(group.next, end - group.next));
  const Span span = cover(cursor.tokens[begin].span, cursor.tokens[end - 1].span);
  if (!takes_second({span, fmt::format("{}{}({}){}", before, blank, inside, behind),
                     fmt::format("{}{}{}{}", before, blank, inside, behind)}))
    return false;
  const auto offset = static_cast<std::size_t>(cursor.tokens.data() - side_.data());
  for (const std::size_t at : {cursor.at, close}) {
    Token& brace = side_[offset + at];
    brace = {TokenKind::space, " ", brace.span, brace.place};
  }
  return true;
}

/// `[T]`, `[T^{-1}]`
bool Parser::holds_one_letter(SyntaxId group) const {
  if (tree_[group].kind != SyntaxKind::group) return false;
  SyntaxId inside = tree_.child(group, 0);
  if (tree_[inside].kind == SyntaxKind::power) {
    const SyntaxId exponent = tree_.child(inside, 1);
    if (tree_[exponent].kind != SyntaxKind::sum) return false;
    inside = tree_.child(inside, 0);
  }
  return tree_[inside].kind == SyntaxKind::symbol;
}

bool Parser::is_bold_letter(SyntaxId group) const {
  const SyntaxId inside = tree_.child(group, 0);
  return tree_[inside].kind == SyntaxKind::symbol && tree_.symbol(inside).face != Face::plain;
}

}  // namespace rigor
