// SPDX-License-Identifier: GPL-3.0-or-later
// Derivatives: dots over an expression, d/dt and ∂/∂x as fractions, with a slash and as operators.
#include <string>
#include <utility>

#include "latex/parse/parse_indices.h"
#include "latex/parse/parser.h"
#include "latex/token/cover_tokens.h"
#include "latex/token/differential.h"

namespace rigor {
namespace {

constexpr int most_dots = 20;

WrittenVariable by_time(std::uint8_t times, Span span) {
  WrittenVariable variable;
  variable.symbol.letter = "t";
  variable.symbol.letter_span = span;
  variable.times = times;
  return variable;
}

int order_of(const std::vector<WrittenVariable>& variables) {
  int order = 0;
  for (const WrittenVariable& variable : variables) order += variable.times;
  return order;
}

/// `\frac{d}{d}` and `\frac{d + a}{dt}` are fractions of letters.
bool goes_on_with_operand(TokenView rest) {
  const std::size_t at = skip_narrow(rest, 0);
  if (at >= rest.size()) return true;
  const Token& token = rest[at];
  return !is_sign_of(token, "+-") && token.text != "−" && factor_joint(token) == Joint::none;
}

/// What comes after the `d` of the numerator.
TokenView operand_above(TokenView above) {
  const TokenView rest = above.subspan(differential_at(above, skip_narrow(above, 0))->next);
  return rest.subspan(skip_narrow(rest, 0));
}

}  // namespace

SyntaxId Parser::dotted(Cursor& cursor) {
  const Token token = cursor.token();
  read_sign(cursor);
  const std::uint8_t dots = dots_of(token);
  const std::size_t at = skip_blank(cursor.tokens, cursor.at + 1);
  SyntaxId inside{};
  Span span = token.span;
  if (starts_accent(cursor.tokens, at)) {
    cursor.at = at;
    inside = nested_accent(cursor);
  } else {
    const Argument argument = argument_at(cursor.tokens, at);
    span = cover(span, cursor.tokens.subspan(at, argument.next - at));
    cursor.at = argument.next;
    inside = inner(argument.content, span);
  }
  span = cover(span, tree_[inside].span);
  if (tree_[inside].kind == SyntaxKind::opaque) return inside;
  if (tree_[inside].kind != SyntaxKind::symbol)
    return tree_.add_derivative(span, {false, {by_time(dots, token.span)}}, inside);
  WrittenSymbol symbol = tree_.symbol(inside);
  if (symbol.dots + dots > most_dots) return opaque(span, "so many dots over a letter are not read");
  symbol.dots = static_cast<std::uint8_t>(symbol.dots + dots);
  symbol.letter_span = span;
  return tree_.add_symbol(span, std::move(symbol));
}

std::optional<std::vector<WrittenVariable>> Parser::variables(TokenView below, bool partial) {
  std::vector<WrittenVariable> all;
  Cursor cursor{below};
  for (cursor.skip_spacing(); !cursor.done(); cursor.skip_spacing()) {
    const auto mark = differential_at(below, cursor.at);
    if (!mark || mark->order != 1 || mark->partial != partial) return std::nullopt;
    const std::size_t end = symbol_end(below, skip_narrow(below, mark->next));
    if (end <= mark->next) return std::nullopt;
    const TokenView written = below.subspan(mark->next, end - mark->next);
    const auto variable = this->variable(inner(written, span_of(written)));
    if (!variable) return std::nullopt;
    all.push_back(*variable);
    cursor.at = end;
  }
  if (all.empty()) return std::nullopt;
  return all;
}

/// `x`, `x_i`, `t^2`: by what is differentiated, and how often.
std::optional<WrittenVariable> Parser::variable(SyntaxId node) const {
  if (tree_[node].kind == SyntaxKind::symbol) return WrittenVariable{tree_.symbol(node)};
  if (tree_[node].kind != SyntaxKind::power) return std::nullopt;
  const SyntaxId base = tree_.child(node, 0);
  const SyntaxId exponent = tree_.child(node, 1);
  const bool greek = tree_[base].kind == SyntaxKind::symbol && tree_[exponent].kind == SyntaxKind::symbol &&
                     tree_.symbol(base).letter == "x" && tree_.symbol(base).lower.empty() &&
                     is_greek(tree_.symbol(exponent).letter);
  if (greek) {  // by `x^\mu`, as \partial_\mu is
    WrittenVariable variable{tree_.symbol(base)};
    variable.symbol.lower.push_back({tree_.symbol(exponent).letter, IndexForm::greek,
                                     tree_.symbol(exponent).primes, tree_[exponent].span});
    return variable;
  }
  if (tree_[base].kind != SyntaxKind::symbol || tree_[exponent].kind != SyntaxKind::number)
    return std::nullopt;
  const std::string& times = tree_.text(exponent);
  if (times.size() != 1 || times == "0") return std::nullopt;
  return WrittenVariable{tree_.symbol(base), static_cast<std::uint8_t>(times[0] - '0')};
}

bool Parser::is_derivative(TokenView above, TokenView below) {
  const auto top = differential_at(above, skip_narrow(above, 0));
  const auto bottom = differential_at(below, skip_narrow(below, 0));
  if (!top || !bottom || !goes_on_with_operand(above.subspan(top->next))) return false;
  const TokenView rest = below.subspan(bottom->next);
  return skip_narrow(rest, 0) < rest.size() && goes_on_with_operand(rest);
}

/// By what `\frac{above}{below}` differentiates, or why that is not read.
std::optional<WrittenDerivative> Parser::written_derivative(TokenView above, TokenView below,
                                                            Obstacle& obstacle) {
  const Differential top = *differential_at(above, skip_narrow(above, 0));
  auto by = variables(below, top.partial);
  if (by && order_of(*by) == top.order) return WrittenDerivative{top.partial, std::move(*by)};
  const bool differ = by && top.order != 0;
  obstacle =
      differ
          ? Obstacle{DiagnosticKind::bad_syntax, "the orders above and below in this derivative differ", {}}
          : Obstacle{DiagnosticKind::unsupported, "this derivative is not read", {}};
  return std::nullopt;
}

SyntaxId Parser::derivative_fraction(Cursor& cursor, TokenView above, TokenView below, Span span) {
  Obstacle obstacle;
  auto derivative = written_derivative(above, below, obstacle);
  if (!derivative) return tree_.add_opaque(span, std::move(obstacle));
  const TokenView rest = operand_above(above);
  read(above.first(above.size() - rest.size()));
  read(below);
  if (rest.empty()) return operate(cursor, std::move(*derivative), span);
  const SyntaxId operand = inner(rest, span);
  if (!is_one_factor(operand)) return unclear_operand(span);
  return tree_.add_derivative(span, std::move(*derivative), operand);
}

/// `f`, `f(x)`: is it plain what the `d` before it differentiates?
bool Parser::is_one_factor(SyntaxId operand) const {
  const SyntaxKind kind = tree_[operand].kind;
  if (kind == SyntaxKind::sum) return false;
  if (kind != SyntaxKind::term) return true;
  const auto factors = tree_.children(operand);
  if (factors.size() != 2 || factors[1].joint != Joint::juxtaposed) return false;
  if (tree_[factors[0].id].kind != SyntaxKind::symbol) return false;
  const SyntaxKind argument = tree_[factors[1].id].kind;
  return argument == SyntaxKind::tuple ||
         (argument == SyntaxKind::group && tree_[tree_.child(factors[1].id, 0)].kind == SyntaxKind::symbol);
}

SyntaxId Parser::unclear_operand(Span span) {
  return opaque(span, "it is not clear how much is differentiated here", DiagnosticKind::ambiguous_reading,
                {"put brackets around what is differentiated"});
}

/// An operator that is before what it acts on: the rest of the term.
SyntaxId Parser::operate(Cursor& cursor, WrittenDerivative derivative, Span span) {
  const bool partial = derivative.partial;
  std::optional<EvaluationBar> bar = evaluation_bar(cursor);
  cursor.skip_spacing();
  const bool nothing = cursor.done() || starts_sign(cursor) || factor_joint(cursor.token()) != Joint::none ||
                       cursor.token().kind == TokenKind::superscript;
  if (nothing) return opaque(span, "this derivative has nothing after it to act on");
  const std::size_t bracket = bracket_end(cursor.tokens, cursor.at);
  const bool bracket_first = bracket != cursor.at;
  const SyntaxId operand = term(cursor);
  const Span whole = cover(span, tree_[operand].span);
  // `\frac{d}{dt}(a + b) c`: half of the readers stop at the bracket.
  if (bracket_first && tree_[operand].kind == SyntaxKind::term) return unclear_operand(whole);
  const SyntaxId node = tree_.add_derivative(whole, std::move(derivative), operand);
  return bar ? in_frame(node, partial, std::move(*bar)) : node;
}

/// `\left(\frac{d}{dt}\right)_{\text{in}}\mathbf A`: the operator alone in the bracket.
std::optional<WrittenDerivative> Parser::operator_in(TokenView content) {
  content = trim(content);
  if (content.size() < 3 || !is_fraction(content[0])) return std::nullopt;
  const Argument above = argument_at(content, 1);
  const Argument below = argument_at(content, above.next);
  if (below.next != content.size() || !is_derivative(above.content, below.content)) return std::nullopt;
  if (!operand_above(above.content).empty()) return std::nullopt;
  Obstacle obstacle;
  auto derivative = written_derivative(above.content, below.content, obstacle);
  if (derivative) read(content);
  return derivative;
}

SyntaxId Parser::bracketed_operator(Cursor& cursor, WrittenDerivative derivative, Span span) {
  const std::size_t script = skip_blank(cursor.tokens, cursor.at);
  if (!is_kind_at(cursor.tokens, script, TokenKind::subscript))
    return operate(cursor, std::move(derivative), span);
  const Argument argument = script_argument_at(cursor.tokens, script + 1);
  IndexReading reading = read_indices(argument.content);
  read(cursor.tokens.subspan(script, argument.next - script));
  cursor.at = argument.next;
  if (reading.obstacle) return tree_.add_opaque(span, *reading.obstacle);
  const SyntaxId node = operate(cursor, std::move(derivative), span);
  if (tree_[node].kind != SyntaxKind::derivative) return node;
  const SyntaxChild child{node};
  const SyntaxId group = tree_.add(SyntaxKind::group, tree_[node].span, {&child, 1});
  return tree_.add_component(tree_[node].span, group, std::move(reading.indices));
}

/// `d\mathbf L/dt`, `dx/dt`, `d/dt`.
std::optional<SyntaxId> Parser::slash_derivative(Cursor& cursor) {
  const TokenView tokens = cursor.tokens;
  const auto top = differential_at(tokens, cursor.at);
  if (!top) return std::nullopt;
  const std::size_t begin = skip_narrow(tokens, top->next);
  std::size_t end = symbol_end(tokens, begin);
  if (end == begin) end = bracket_end(tokens, begin);
  const std::size_t slash = skip_blank(tokens, end);
  if (!is_sign_at(tokens, slash, "/")) return std::nullopt;
  const std::size_t below = skip_blank(tokens, slash + 1);
  const auto bottom = differential_at(tokens, below);
  if (!bottom || bottom->partial != top->partial) return std::nullopt;
  const std::size_t close = symbol_end(tokens, bottom->next);
  if (close == bottom->next) return std::nullopt;
  const Span span = span_of(tokens.subspan(cursor.at, close - cursor.at));
  read(tokens.subspan(cursor.at, begin - cursor.at));
  read(tokens.subspan(end, close - end));
  cursor.at = close;
  const auto by = variables(tokens.subspan(below, close - below), top->partial);
  if (!by || order_of(*by) != top->order) return opaque(span, "this derivative is not read");
  if (end == begin) return operate(cursor, {top->partial, *by}, span);
  return tree_.add_derivative(span, {top->partial, *by}, inner(tokens.subspan(begin, end - begin), span));
}

}  // namespace rigor
