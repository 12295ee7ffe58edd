// SPDX-License-Identifier: GPL-3.0-or-later
// What is struck out, `\cancel{x}`, and what it cancels against.
#include <fmt/format.h>

#include <algorithm>

#include "latex/parse/parser.h"
#include "latex/token/cover_tokens.h"
#include "latex/token/differential.h"

namespace rigor {
namespace {

constexpr std::size_t longest_side = 4'000;  // tokens that are searched for the other half of a pair

bool is_strike(const Token& token) { return is_control_of(token, {"cancel", "bcancel", "xcancel"}); }

bool is_sign_of_sum(const Token& token) { return is_sign_of(token, "+-") || token.text == "−"; }

/// Is the same struck out in these tokens?
bool strikes_in(TokenView tokens, const std::string& text) {
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    if (is_strike(tokens[at]) && text_of(argument_at(tokens, at + 1).content) == text) return true;
  }
  return false;
}

enum class Strike : std::uint8_t { alone, factor, pair };

/// `\frac{\cancel{x}y}{\cancel{x}}`: what the place in `side` is to the fractions around it.
Strike strike_in_fractions(TokenView side, std::size_t place, const std::string& text) {
  Strike found = Strike::alone;
  for (std::size_t at = 0; at < place; ++at) {
    if (!is_fraction(side[at])) continue;
    const Argument above = argument_at(side, at + 1);
    const Argument below = argument_at(side, above.next);
    if (place >= below.next) continue;
    const bool on_top = place < above.next;
    if (strikes_in(on_top ? below.content : above.content, text)) return Strike::pair;
    found = Strike::factor;
  }
  const auto slash = std::ranges::find_if(side, [](const Token& token) { return is_sign(token, "/"); });
  if (slash == side.end()) return found;
  const auto middle = static_cast<std::size_t>(slash - side.begin());
  const TokenView other = place < middle ? side.subspan(middle) : side.first(middle);
  return strikes_in(other, text) ? Strike::pair : found;
}

/// A whole term of a sum: whether a sign before it says minus; nothing for a factor.
std::optional<bool> sign_of_term(TokenView tokens, std::size_t at, std::size_t next) {
  const auto means_nothing = [](const Token& token) { return is_blank(token) || is_spacing(token); };
  while (at > 0 && means_nothing(tokens[at - 1])) --at;
  while (next < tokens.size() && means_nothing(tokens[next])) ++next;
  const bool begins = at == 0 || is_sign_of_sum(tokens[at - 1]);
  const bool ends = next >= tokens.size() || is_sign_of_sum(tokens[next]);
  if (!begins || !ends) return std::nullopt;
  return at > 0 && !is_sign(tokens[at - 1], "+");
}

/// `\cancel{x} + y - \cancel{x}`
bool cancels_in_sum(TokenView tokens, const std::string& text, bool minus) {
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    if (!is_strike(tokens[at])) continue;
    const Argument other = argument_at(tokens, at + 1);
    const auto sign = sign_of_term(tokens, at, other.next);
    if (sign && *sign != minus && text_of(other.content) == text) return true;
  }
  return false;
}

}  // namespace

/// Read as if it were not struck out where it is a factor, or cancels against a term of the same text. A term
/// alone is dropped for a reason that is not read. A letter alone is also written so for a contraction with
/// Dirac's matrices; and what fails is never refuted, since what is struck out may be 0.
SyntaxId Parser::struck(Cursor& cursor) {
  const TokenView tokens = cursor.tokens;
  const std::size_t begin = cursor.at;
  const Argument argument = argument_at(tokens, begin + 1);
  const TokenView content = trim(argument.content);
  const Span span = cover(tokens[begin].span, tokens.subspan(begin, argument.next - begin));
  const std::string text = text_of(content);
  const std::string written = fmt::format("\\{}{{{}}}", tokens[begin].text, text);
  cursor.at = argument.next;
  const Token* here = &tokens[begin];
  const bool known =
      here >= side_.data() && here < side_.data() + side_.size() && side_.size() <= longest_side;
  const TokenView side = known ? TokenView(side_) : TokenView();
  const std::size_t place = known ? static_cast<std::size_t>(here - side.data()) : 0;
  Strike strike = strike_in_fractions(side, place, text);
  const auto sign = known ? sign_of_term(tokens, begin, argument.next) : std::nullopt;
  if (strike != Strike::pair && sign && cancels_in_sum(tokens, text, *sign)) strike = Strike::pair;
  if (strike == Strike::alone && known && !sign) strike = Strike::factor;
  const bool one_letter =
      !content.empty() &&
      (symbol_end(content, 0) == content.size() ||
       (content.size() == 1 && (is_partial(content[0]) || is_control(content[0], "nabla"))));
  if (strike != Strike::pair && one_letter)
    return opaque(
        span, fmt::format("`{}` can be `{}` struck out, or contracted with Dirac's matrices", written, text),
        DiagnosticKind::ambiguous_reading);
  const std::size_t behind = skip_blank(tokens, cursor.at);
  if (is_kind_at(tokens, behind, TokenKind::superscript) || is_kind_at(tokens, behind, TokenKind::subscript))
    return opaque(span, fmt::format("what stands beside `{}` can be its script, or take its place", written),
                  DiagnosticKind::ambiguous_reading);
  if (strike == Strike::alone)
    return opaque(span,
                  fmt::format("why `{}` is struck out is not read: it may be 0 or small here", written));
  read(tokens.subspan(begin, argument.next - begin));
  const SyntaxChild children[] = {{inner(argument.content, span)},
                                  {opaque(span, fmt::format("`{}` is struck out, and may be 0 here", written),
                                          DiagnosticKind::restricted)}};
  return tree_.add(SyntaxKind::group, span, children);
}

SyntaxId Parser::struck_to(Cursor& cursor) {
  const TokenView tokens = cursor.tokens;
  const std::size_t begin = cursor.at;
  const Argument value = argument_at(tokens, begin + 1);
  const Argument argument = argument_at(tokens, value.next);
  cursor.at = argument.next;
  return opaque(cover(tokens[begin].span, tokens.subspan(begin, argument.next - begin)),
                fmt::format("that `{}` becomes `{}` here is not read", text_of(trim(argument.content)),
                            text_of(trim(value.content))));
}

}  // namespace rigor
