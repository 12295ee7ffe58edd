// SPDX-License-Identifier: GPL-3.0-or-later
// Angle brackets, which hold averages or states, and brackets of two operators.
#include <algorithm>

#include "base/among.h"
#include "latex/parse/parser.h"
#include "latex/token/cover_tokens.h"
#include "latex/token/state_places.h"

namespace rigor {
namespace {

std::size_t behind_stars(TokenView tokens, std::size_t at) {
  while (is_sign_at(tokens, at, "*")) ++at;
  return skip_blank(tokens, at);
}

/// `\langle a | H | b\rangle`, `\langle a |`: the place behind it.
std::size_t behind_angles(TokenView tokens, std::size_t open) {
  int depth = 0;
  for (std::size_t at = open; at < tokens.size(); ++at) {
    if (is_control(tokens[at], "langle") && ++depth > deepest_states) return open + 1;
    if (is_control(tokens[at], "rangle") && --depth == 0) return at + 1;
  }
  const auto is_bar = [](const Token& token) {
    return is_sign(token, "|") || is_control_of(token, {"vert", "rvert"});
  };
  const auto bar = std::ranges::find_if(tokens.subspan(open), is_bar);
  const auto behind = static_cast<std::size_t>(bar - tokens.begin());
  return behind < tokens.size() ? behind + 1 : open + 1;
}

/// What stands in them outside of other brackets.
std::size_t count_outside(TokenView content, bool (*is_it)(const Token&)) {
  Nesting nesting(false);
  int angles = 0;
  std::size_t count = 0;
  for (const Token& token : content) {
    if (is_control(token, "langle")) ++angles;
    if (is_control(token, "rangle")) --angles;
    if (nesting.enter(token) == 0 && angles == 0 && is_it(token)) ++count;
  }
  return count;
}

bool is_bar_of_state(const Token& token) {
  return is_sign(token, "|") || is_control_of(token, {"vert", "mid", "middle"});
}
bool is_separator(const Token& token) { return is_sign_of(token, ",;"); }

/// `\langle x^2\rangle` and `\langle|v|\rangle`, but not `\langle a|b\rangle`.
bool has_no_states(TokenView content) {
  content = trim(content);
  const std::size_t bars = count_outside(content, is_bar_of_state);
  return !content.empty() && (bars == 0 || (bars == 2 && is_bar_of_state(content.front())));
}

/// What `\langle…\rangle`, `\ev{…}` or `\Braket{…}` hold, if it can be averaged. `\braket{a}` is
/// $\langle a\rangle$ to one package and $\langle a|a\rangle$ to another.
std::optional<TokenView> averaged_part(TokenView tokens, std::size_t begin, std::size_t end) {
  std::optional<TokenView> content;
  if (is_control(tokens[begin], "langle")) {
    if (end > begin + 1 && is_control(tokens[end - 1], "rangle"))
      content = tokens.subspan(begin + 1, end - begin - 2);
  } else if (is_control_of(tokens[begin], {"ev", "expval", "expectationvalue", "Braket"})) {
    const std::size_t open = behind_stars(tokens, begin + 1);
    const bool one =
        is_kind_at(tokens, open, TokenKind::begin_group) && argument_at(tokens, open).next == end;
    if (one) content = argument_at(tokens, open).content;
  }
  if (!content || !has_no_states(*content)) return std::nullopt;
  return content;
}

}  // namespace

/// An average, what states make, or one obstacle for the whole of it.
std::optional<SyntaxId> Parser::state_bracket(Cursor& cursor) {
  const TokenView tokens = cursor.tokens;
  const std::size_t begin = cursor.at;
  if (is_control(tokens[begin], "langle")) {
    if (const auto states = angles_of_states(cursor)) return states;
    cursor.at = behind_angles(tokens, begin);
  } else if (is_state_bracket(tokens[begin])) {
    if (const auto states = named_states(cursor)) return states;
    std::size_t at = behind_stars(tokens, begin + 1);
    cursor.at = argument_at(tokens, at).next;
    for (at = skip_blank(tokens, cursor.at); is_kind_at(tokens, at, TokenKind::begin_group);
         at = skip_blank(tokens, cursor.at))
      cursor.at = argument_at(tokens, at).next;
  } else {
    return std::nullopt;
  }
  const Span span = cover(tokens[begin].span, tokens.subspan(begin, cursor.at - begin));
  const auto content = averaged_part(tokens, begin, cursor.at);
  if (!content) return opaque(span, "brackets of states are not read");
  if (count_outside(*content, is_separator) > 0)
    return opaque(
        span, "angle brackets around several parts can be an inner product, or a vector by its components",
        DiagnosticKind::ambiguous_reading);
  if (is_kind_at(tokens, skip_blank(tokens, cursor.at), TokenKind::subscript))
    return opaque(span, "an average with a subscript is not read");
  const auto first = static_cast<std::size_t>(content->data() - tokens.data());
  read(tokens.subspan(begin, first - begin));
  read(tokens.subspan(first + content->size(), cursor.at - first - content->size()));
  const SyntaxId inside = in_brackets(*content, span);
  return tree_.add_named(SyntaxKind::function, span, "average", inside);
}

/// `x - \langle x\rangle`
SyntaxId Parser::deviation(SyntaxId of, Span span) {
  const SyntaxChild parts[] = {
      {of, Joint::plus, span},
      {tree_.add_named(SyntaxKind::function, span, "average", of), Joint::minus, span}};
  const SyntaxChild sum{tree_.add(SyntaxKind::sum, span, parts)};
  return tree_.add(SyntaxKind::group, span, {&sum, 1});
}

/// `\mathbb E[X]`, `\operatorname{Var}(X)` and `\operatorname{Cov}(X, Y)`, which are averages.
std::optional<SyntaxId> Parser::expectation(Cursor& cursor) {
  const TokenView tokens = cursor.tokens;
  const std::size_t begin = cursor.at;
  if (!is_control_of(tokens[begin], {"mathbb", "mathrm", "operatorname"})) return std::nullopt;
  const Argument argument = argument_at(tokens, begin + 1);
  const std::string name = text_of(argument.content);
  const bool mean = name == "E" && is_control_of(tokens[begin], {"mathbb", "operatorname"});
  const bool square = name == "Var" || name == "var" || name == "Cov" || name == "cov";
  const std::size_t open = skip_blank(tokens, argument.next);
  const bool bracket =
      open < tokens.size() && (is_sign_of(tokens[open], "([") || is_control(tokens[open], "{"));
  if ((!mean && !square) || !bracket) return std::nullopt;
  Nesting nesting(false);
  std::size_t close = open;
  while (close < tokens.size() && (nesting.enter(tokens[close]) != 0 || close == open)) ++close;
  if (close >= tokens.size()) return std::nullopt;
  const TokenView content = tokens.subspan(open + 1, close - open - 1);
  const Span span = cover(tokens[begin].span, tokens[close].span);
  const bool pair = name == "Cov" || name == "cov";
  const std::size_t separators = count_outside(content, is_separator);
  if (!has_no_states(content) || separators != (pair ? 1U : 0U)) return std::nullopt;
  cursor.at = close + 1;
  read(tokens.subspan(begin, open + 1 - begin));
  read(tokens.subspan(close, 1));
  const auto average = [&](SyntaxId of) {
    return tree_.add_named(SyntaxKind::function, span, "average", of);
  };
  if (mean) return average(inner(content, span));
  if (!pair) {
    const SyntaxChild parts[] = {{deviation(inner(content, span), span)},
                                 {tree_.add_text(SyntaxKind::number, span, "2")}};
    return average(tree_.add(SyntaxKind::power, span, parts));
  }
  Nesting inside(false);
  std::size_t comma = 0;
  while (inside.enter(content[comma]) != 0 || !is_separator(content[comma])) ++comma;
  read(content.subspan(comma, 1));
  const SyntaxChild parts[] = {
      {deviation(inner(content.first(comma), span), span), Joint::none, span},
      {deviation(inner(content.subspan(comma + 1), span), span), Joint::juxtaposed, span}};
  return average(tree_.add(SyntaxKind::term, span, parts));
}

/// `\comm{A}{B}` is `[A, B]` and `\acomm{A}{B}` is `\{A, B\}`; `\pb` is no commutator, whatever is in it.
std::optional<SyntaxId> Parser::pair_in_brackets(Cursor& cursor) {
  static const WordSet names("comm commutator acomm anticommutator pb poissonbracket");
  const TokenView tokens = cursor.tokens;
  const std::size_t begin = cursor.at;
  if (!is_control_of(tokens[begin], names)) return std::nullopt;
  const std::uint32_t pair = is_control_of(tokens[begin], {"comm", "commutator"})     ? in_square_brackets
                             : is_control_of(tokens[begin], {"pb", "poissonbracket"}) ? in_poisson_brackets
                                                                                      : in_braces;
  const std::size_t open = behind_stars(tokens, begin + 1);
  if (!is_kind_at(tokens, open, TokenKind::begin_group)) return std::nullopt;
  const Argument first = argument_at(tokens, open);
  const std::size_t again = skip_blank(tokens, first.next);
  if (!is_kind_at(tokens, again, TokenKind::begin_group)) return std::nullopt;
  const Argument second = argument_at(tokens, again);
  cursor.at = second.next;
  read_since(cursor, begin);
  const Span span = cover(tokens[begin].span, tokens.subspan(begin, second.next - begin));
  const SyntaxChild children[] = {{inner(first.content, span), Joint::comma, span},
                                  {inner(second.content, span), Joint::comma, span}};
  return tree_.add(SyntaxKind::tuple, span, children, pair);
}

}  // namespace rigor
