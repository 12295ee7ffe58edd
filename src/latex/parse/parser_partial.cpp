// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives in other forms: `\dv` and `\pdv`, ∂_i, and bars that say in which frame a derivative is taken.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "base/among.h"
#include "latex/parse/parse_indices.h"
#include "latex/parse/parser.h"
#include "latex/token/differential.h"

namespace rigor {
namespace {

bool may_be_coordinate(const WrittenIndex& index) {
  static constexpr std::string_view coordinates[] = {"t", "x",       "y",        "z",     "u",     "v",
                                                     "w", "\\theta", "\\varphi", "\\phi", "\\psi", "\\tau"};
  return index.primes == 0 && is_one_of(index.text, coordinates);
}

/// ∂_t and ∂_x are by that coordinate, ∂_i and ∂_1 by x_i and x_1.
WrittenVariable coordinate_of(const WrittenIndex& index) {
  WrittenVariable variable;
  variable.symbol.letter_span = index.span;
  if (may_be_coordinate(index)) {
    variable.symbol.letter = index.text;
  } else {
    variable.symbol.letter = "x";
    variable.symbol.lower.push_back(index);
  }
  return variable;
}

/// `x, y` of the derivative package: what is between the commas outside all braces.
std::vector<TokenView> listed(TokenView tokens) {
  std::vector<TokenView> parts;
  Nesting nesting(false);
  std::size_t begin = 0;
  for (std::size_t at = 0; at <= tokens.size(); ++at) {
    const bool comma = at < tokens.size() && nesting.enter(tokens[at]) == 0 && is_sign(tokens[at], ",");
    if (!comma && at < tokens.size()) continue;
    parts.push_back(tokens.subspan(begin, at - begin));
    begin = at + 1;
  }
  return parts;
}

}  // namespace

/// `\dv{x}{t}`, `\dv[2]{x}{t}`, `\dv{t}`, `\pdv{f}{x}{y}`, `\pdv{f}{x,y}`: the packages physics and
/// derivative.
SyntaxId Parser::physics_derivative(Cursor& cursor, bool partial) {
  const TokenView tokens = cursor.tokens;
  const std::size_t begin = cursor.at;
  std::size_t at = skip_blank(tokens, begin + 1);
  if (is_sign_at(tokens, at, "*")) ++at;
  const Argument order = optional_argument_at(tokens, at);
  std::vector<Argument> arguments{argument_at(tokens, order.next)};
  while (arguments.size() < 3) {
    const std::size_t open = skip_blank(tokens, arguments.back().next);
    if (!is_kind_at(tokens, open, TokenKind::begin_group)) break;
    if (arguments.size() == 2 && !partial) break;
    arguments.push_back(argument_at(tokens, open));
  }
  read(tokens.subspan(begin, order.next - begin));
  cursor.at = arguments.back().next;
  const Span span = span_of(tokens.subspan(begin, cursor.at - begin));
  const bool acts = arguments.size() > 1 && !trim(arguments[0].content).empty();
  std::vector<WrittenVariable> by;
  for (std::size_t k = arguments.size() > 1 ? 1 : 0; k < arguments.size(); ++k) {
    for (const TokenView written : listed(arguments[k].content)) {
      const auto variable = this->variable(inner(written, span));
      if (!variable || variable->times != 1) return opaque(span, "this derivative is not read");
      if (written.data() != arguments[k].content.data()) read({written.data() - 1, 1});
      by.push_back(*variable);
    }
  }
  if (order.next != at) {
    const std::string times = text_of(order.content);
    if (times.size() != 1 || times[0] < '1' || times[0] > '9' || by.size() > 1)
      return opaque(span, "the order of this derivative is not read");
    by[0].times = static_cast<std::uint8_t>(times[0] - '0');
  }
  if (!acts) return operate(cursor, {partial, std::move(by)}, span);
  return tree_.add_derivative(span, {partial, std::move(by)}, inner(arguments[0].content, span));
}

/// How often a derivative is taken: `\partial_x^2`. `\partial_i^2` can be a sum over i.
bool Parser::take_times(TokenView order, std::vector<WrittenVariable>& by) {
  const TokenView digit = trim(order);
  if (by.size() != 1 || digit.size() != 1 || digit[0].kind != TokenKind::digit || digit[0].text[0] < '1')
    return false;
  const bool summed = std::ranges::any_of(
      by[0].symbol.lower, [](const WrittenIndex& index) { return index.form != IndexForm::digit; });
  if (summed) return false;
  by[0].times = static_cast<std::uint8_t>(digit[0].text[0] - '0');
  read(order);
  return true;
}

/// `(x, t)` behind `\partial_t u`, `(x)` behind `\partial_x f`.
bool Parser::shows_arguments(const Cursor& cursor, const std::vector<WrittenVariable>& by) {
  if (!is_sign_at(cursor.tokens, cursor.at, "(")) return false;
  bool comma = false;
  std::vector<std::string_view> letters;
  for (std::size_t at = cursor.at + 1; at < cursor.tokens.size(); ++at) {
    const Token& token = cursor.tokens[at];
    if (is_sign(token, ")")) {
      const bool same = letters.size() == 1 && std::ranges::any_of(by, [&](const WrittenVariable& each) {
                          return each.symbol.letter == letters[0];
                        });
      return same || (comma && letters.size() > 1);
    }
    comma = comma || is_sign(token, ",");
    if (token.kind == TokenKind::letter) letters.push_back(token.text);
    if (token.kind != TokenKind::letter && token.kind != TokenKind::space && !is_sign(token, ",") &&
        !is_control_of(token, {",", " ", ";", "!"}))
      return false;
  }
  return false;
}

/// `\partial_i f`: acts on the next factor; where another one follows that it could act on too, it is not
/// read.
SyntaxId Parser::partial(Cursor& cursor) {
  if (const auto slash = slash_derivative(cursor)) return *slash;
  const Token token = cursor.token();
  const TokenView tokens = cursor.tokens;
  std::size_t script = skip_blank(tokens, cursor.at + 1);
  read_sign(cursor);
  ++cursor.at;
  std::optional<Argument> order;  // `\partial^2_x`, `\partial_x^2`
  const auto take_order = [&](std::size_t at) {
    if (order || !is_kind_at(tokens, at, TokenKind::superscript)) return at;
    order = script_argument_at(tokens, at + 1);
    read(tokens.subspan(at, 1));
    return skip_blank(tokens, order->next);
  };
  script = take_order(script);
  if (order && !is_kind_at(tokens, script, TokenKind::subscript)) {
    if (auto raised = read_raised_indices(order->content)) {
      cursor.at = order->next;
      return act_by(cursor, *std::move(raised), cover(token.span, span_of(order->content)));
    }
  }
  if (!is_kind_at(tokens, script, TokenKind::subscript))
    return opaque(token.span, "`\\partial` without an index or a fraction is not read");
  const Argument argument = script_argument_at(tokens, script + 1);
  cursor.at = argument.next;
  read(tokens.subspan(script, 1));
  std::vector<WrittenVariable> by;
  auto obstacle = read_partial_index(argument.content, by);
  const std::size_t above = skip_blank(tokens, cursor.at);
  if (const std::size_t behind = take_order(above); behind != above) cursor.at = order->next;
  const Span span = cover(token.span, span_of(tokens.subspan(script, cursor.at - script)));
  if (obstacle) return tree_.add_opaque(span, *obstacle);
  if (order && !take_times(order->content, by)) return opaque(span, "a power of `\\partial` is not read");
  return act_by(cursor, std::move(by), span);
}

/// `^\mu`, `^{\mu\nu}`: Greek letters, and nothing else.
std::optional<std::vector<WrittenVariable>> Parser::read_raised_indices(TokenView content) {
  const IndexReading reading = read_indices(content);
  const auto is_greek_index = [](const WrittenIndex& index) {
    return index.form == IndexForm::greek && index.primes == 0;
  };
  if (reading.obstacle || reading.indices.empty() || !std::ranges::all_of(reading.indices, is_greek_index))
    return std::nullopt;
  std::vector<WrittenVariable> by;
  for (WrittenIndex index : reading.indices) {
    index.raised = true;
    WrittenVariable variable;
    variable.symbol.letter = "x";
    variable.symbol.letter_span = index.span;
    variable.symbol.lower.push_back(std::move(index));
    by.push_back(std::move(variable));
  }
  read(content);
  return by;
}

/// What ∂ acts on, which begins at the cursor. `span`: of ∂ with its scripts.
SyntaxId Parser::act_by(Cursor& cursor, std::vector<WrittenVariable> by, Span span) {
  cursor.skip_spacing();
  if (cursor.done() || starts_sign(cursor) || factor_joint(cursor.token()) != Joint::none)
    return opaque(span, "this derivative has nothing after it to act on");
  if (cursor.token().kind == TokenKind::superscript) {
    cursor.at = script_argument_at(cursor.tokens, cursor.at + 1).next;
    return opaque(span, "a power of `\\partial` is not read");
  }
  std::vector<SyntaxChild> factors;
  bool more = true;
  while (more && (factors.empty() || is_constant(factors.back().id))) {
    factors.push_back({factor(cursor), factors.empty() ? Joint::none : Joint::juxtaposed});
    cursor.skip_spacing();
    more = !cursor.done() && !starts_sign(cursor) && factor_joint(cursor.token()) == Joint::none;
  }
  if (more && factors.size() == 1 && tree_[factors[0].id].kind == SyntaxKind::symbol &&
      shows_arguments(cursor, by)) {
    factors.push_back({factor(cursor), Joint::juxtaposed});
    cursor.skip_spacing();
    more = !cursor.done() && !starts_sign(cursor) && factor_joint(cursor.token()) == Joint::none;
  }
  const Span behind = cover(tree_[factors.front().id].span, tree_[factors.back().id].span);
  const Span whole = cover(span, behind);
  if (more && !is_control(cursor.token(), "partial")) return unclear_operand(whole);
  const SyntaxId operand = factors.size() == 1 ? factors[0].id : tree_.add(SyntaxKind::term, behind, factors);
  return tree_.add_derivative(whole, {true, std::move(by)}, operand);
}

/// A number, δ or ε: whether it is differentiated makes no difference.
bool Parser::is_constant(SyntaxId id) const {
  const auto is_number = [&](SyntaxId each) { return tree_[each].kind == SyntaxKind::number; };
  if (tree_[id].kind == SyntaxKind::fraction) {
    return std::ranges::all_of(tree_.children(id),
                               [&](const SyntaxChild& part) { return is_number(part.id); });
  }
  if (tree_[id].kind != SyntaxKind::symbol) return is_number(id);
  const WrittenSymbol& symbol = tree_.symbol(id);
  return (symbol.letter == "\\delta" && symbol.lower.size() == 2) ||
         (symbol.letter == "\\epsilon" && symbol.lower.size() == 3);
}

std::optional<Obstacle> Parser::read_partial_index(TokenView content, std::vector<WrittenVariable>& by) {
  const bool nested =
      std::ranges::any_of(content, [](const Token& token) { return token.kind == TokenKind::subscript; });
  if (nested) {  // \partial_{x_i}
    const auto variable = this->variable(inner(content, span_of(content)));
    if (!variable)
      return Obstacle{
          DiagnosticKind::unsupported, fmt::format("a derivative by `{}` is not read", text_of(content)), {}};
    by.push_back(*variable);
    return std::nullopt;
  }
  const IndexReading reading = read_indices(content);
  if (reading.obstacle) return reading.obstacle;
  if (reading.indices.empty()) return Obstacle{DiagnosticKind::bad_syntax, "the subscript is empty", {}};
  for (const WrittenIndex& index : reading.indices) {
    const bool either = is_one_of(index.text, {"r", "s"}) || index.form == IndexForm::word;
    if (either)
      return Obstacle{DiagnosticKind::ambiguous_reading,
                      fmt::format("`{}` can be an index here, or the variable of the derivative", index.text),
                      {"write `\\frac{\\partial}{\\partial r}` for a derivative by `r`"}};
    by.push_back(coordinate_of(index));
  }
  read(content);
  return std::nullopt;
}

/// `\right|_{\text{in}}`, `\bigg|_{x=0}` after an expression.
std::optional<Parser::EvaluationBar> Parser::evaluation_bar(Cursor& cursor) {
  const TokenView tokens = cursor.tokens;
  const std::size_t bar = skip_narrow(tokens, cursor.at);
  if (bar >= tokens.size()) return std::nullopt;
  if (!is_sign(tokens[bar], "|") && !is_control(tokens[bar], "vert") && !is_control(tokens[bar], "rvert"))
    return std::nullopt;
  const std::size_t script = skip_blank(tokens, bar + 1);
  if (!is_kind_at(tokens, script, TokenKind::subscript)) return std::nullopt;
  const Argument argument = script_argument_at(tokens, script + 1);
  const std::size_t above = skip_blank(tokens, argument.next);
  const bool limits = is_kind_at(tokens, above, TokenKind::superscript);
  if (limits) {
    const Argument upper = script_argument_at(tokens, above + 1);
    cursor.at = upper.next;
    for (const std::size_t sign : {bar, script, above}) read(tokens.subspan(sign, 1));
    return EvaluationBar{.indices = {},
                         .span = span_of(tokens.subspan(bar, cursor.at - bar)),
                         .text = {},
                         .limits = std::pair(argument.content, upper.content)};
  }
  cursor.at = argument.next;
  read(tokens.subspan(bar, cursor.at - bar));
  IndexReading reading = read_indices(argument.content);
  const bool named = !reading.obstacle && !reading.indices.empty() &&
                     std::ranges::none_of(reading.indices, [](const WrittenIndex& index) {
                       return index.form == IndexForm::digit;
                     });
  return EvaluationBar{named ? std::move(reading.indices) : std::vector<WrittenIndex>{},
                       span_of(tokens.subspan(bar, cursor.at - bar)), text_of(argument.content)};
}

SyntaxId Parser::in_frame(SyntaxId node, bool partial, EvaluationBar bar) {
  const Span span = cover(tree_[node].span, bar.span);
  if (tree_[node].kind == SyntaxKind::opaque) return node;
  if (bar.limits) return between(node, bar.limits->first, bar.limits->second, span);
  if (tree_[node].kind != SyntaxKind::derivative || partial || bar.indices.empty())
    return opaque(
        span,
        fmt::format("the value at `{}` is not read: a bar is read where it names the frame of a derivative",
                    bar.text));
  const SyntaxChild child{node};
  const SyntaxId group = tree_.add(SyntaxKind::group, tree_[node].span, {&child, 1});
  return tree_.add_component(span, group, std::move(bar.indices));
}

}  // namespace rigor
