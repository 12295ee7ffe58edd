// SPDX-License-Identifier: GPL-3.0-or-later
// Functions and where their arguments end.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "latex/differential.h"
#include "latex/parse.h"
#include "latex/parser.h"

namespace rigor {
namespace {

bool is_bold(TokenView tokens, std::size_t at) {
  if (at >= tokens.size()) return false;
  const auto style = style_of(tokens[at]);
  return style && style->face != Face::plain;
}

bool opens_bracket(const Token& token) {
  return is_sign(token, "(") || is_sign(token, "[") || is_control(token, "{") ||
         is_control(token, "lbrace") || token.kind == TokenKind::begin_group;
}

/// One of the plain letters, numbers and fractions that an argument without brackets is made of.
bool is_plain_factor(TokenView tokens, std::size_t at) {
  const Token& token = tokens[at];
  if (token.kind == TokenKind::digit) return true;
  if (is_sign(token, ".")) return at + 1 < tokens.size() && tokens[at + 1].kind == TokenKind::digit;
  if (is_control(token, "frac") || is_control(token, "tfrac") || is_control(token, "dfrac") ||
      is_control(token, "sqrt"))
    return true;
  if (!letter_of(token).empty()) return true;
  if (const auto style = style_of(token)) return style->face == Face::plain && !style->upright;
  if (dots_of(token) == 0) return false;
  const Argument argument = argument_at(tokens, at + 1);
  return std::none_of(argument.content.begin(), argument.content.end(), [](const Token& inside) {
    const auto style = style_of(inside);
    return style && style->face != Face::plain;
  });
}

/// `\cos\theta\,d m`: the differential of an integral is no part of the argument.
bool starts_differential(TokenView tokens, std::size_t at) {
  const auto mark = differential_at(tokens, at);
  return mark && symbol_end(tokens, mark->next) != mark->next;
}

}  // namespace

/// `behind`: the place behind the name as it is written.
SyntaxId Parser::function(Cursor& cursor, std::string_view name, std::size_t behind) {
  const Token token = cursor.token();
  const std::size_t begin = std::exchange(cursor.at, behind);
  read_since(cursor, begin);
  std::size_t script = skip_blank(cursor.tokens, cursor.at);
  std::optional<Argument> exponent;
  Span place;
  if (script < cursor.tokens.size() && cursor.tokens[script].kind == TokenKind::superscript) {
    exponent = script_argument_at(cursor.tokens, script + 1);
    place = span_of(cursor.tokens.subspan(script, exponent->next - script));
    read(cursor.tokens.subspan(script, 1));
    cursor.at = exponent->next;
    script = skip_blank(cursor.tokens, cursor.at);
  }
  const bool other = script < cursor.tokens.size() && (cursor.tokens[script].kind == TokenKind::subscript ||
                                                       is_sign(cursor.tokens[script], "'"));
  const SyntaxId argument = function_argument(cursor, token.span, name);
  const Span span = cover(token.span, tree_[argument].span);
  if (other) return opaque(span, fmt::format("a script on `{}` is not read", name));
  if (exponent && text_of(exponent->content) == "-1")
    return opaque(span, fmt::format("`{}^{{-1}}` is an inverse function, or a power; it is not read", name));
  if (tree_[argument].kind == SyntaxKind::opaque) return argument;
  const SyntaxId node = tree_.add_named(SyntaxKind::function, span, std::string(name), argument);
  return exponent ? this->exponent(node, exponent->content, place) : node;
}

SyntaxId Parser::function_argument(Cursor& cursor, Span place, std::string_view name) {
  cursor.at = skip_narrow(cursor.tokens, cursor.at);
  if (!cursor.done() && cursor.token().kind == TokenKind::subscript)
    cursor.at = skip_narrow(cursor.tokens, script_argument_at(cursor.tokens, cursor.at + 1).next);
  if (cursor.done() || starts_sign(cursor) || factor_joint(cursor.token()) != Joint::none)
    return opaque(place, fmt::format("`{}` has no argument", name), DiagnosticKind::bad_syntax);
  if (opens_bracket(cursor.token())) return bracket_argument(cursor);
  if (is_bold(cursor.tokens, cursor.at) || !is_plain_factor(cursor.tokens, cursor.at)) {
    const bool matrix_function = name == "det" || name == "tr";
    const SyntaxId argument = factor(cursor);
    const std::size_t next = skip_narrow(cursor.tokens, cursor.at);
    if (matrix_function && is_bold(cursor.tokens, next)) return unclear_argument(place, name);
    return argument;
  }
  return plain_argument(cursor, name);
}

SyntaxId Parser::bracket_argument(Cursor& cursor) {
  const SyntaxId argument = primary(cursor);
  return tree_[argument].kind == SyntaxKind::group ? tree_.child(argument, 0) : argument;
}

SyntaxId Parser::unclear_argument(Span span, std::string_view name) {
  return opaque(span, fmt::format("it is not clear where the argument of `{}` ends", name),
                DiagnosticKind::ambiguous_reading, {"put brackets around the argument"});
}

/// `\cos 2\omega t`: the letters, numbers and fractions that follow.
SyntaxId Parser::plain_argument(Cursor& cursor, std::string_view name) {
  std::vector<SyntaxChild> factors;
  Span span = cursor.token().span;
  while (true) {
    const std::size_t next = skip_blank(cursor.tokens, cursor.at);
    if (next >= cursor.tokens.size() || !is_plain_factor(cursor.tokens, next)) break;
    if (!factors.empty() && starts_differential(cursor.tokens, next)) break;
    cursor.at = next;
    const Span joint = cursor.token().span;
    const SyntaxId node = factor(cursor);
    // `\cos\theta\dot\theta` and `\cos\theta\delta\theta` are products, `\sin\Omega\Delta t` is none.
    if (!factors.empty() && is_rate_or_change(node)) return unclear_argument(cover(span, joint), name);
    span = cover(span, tree_[node].span);
    factors.push_back({node, factors.empty() ? Joint::none : Joint::juxtaposed, joint});
  }
  // `\sin\theta/2` is read both ways.
  const std::size_t slash = skip_narrow(cursor.tokens, cursor.at);
  if (slash < cursor.tokens.size() && is_sign(cursor.tokens[slash], "/")) {
    const std::size_t below = skip_narrow(cursor.tokens, slash + 1);
    if (below < cursor.tokens.size() && is_plain_factor(cursor.tokens, below))
      return unclear_argument(span, name);
  }
  return factors.size() == 1 ? factors[0].id : tree_.add(SyntaxKind::term, span, factors);
}

bool Parser::is_rate_or_change(SyntaxId node) const {
  if (tree_[node].kind == SyntaxKind::power) node = tree_.child(node, 0);
  if (tree_[node].kind == SyntaxKind::derivative) return true;
  if (tree_[node].kind != SyntaxKind::symbol) return false;
  const WrittenSymbol& symbol = tree_.symbol(node);
  return symbol.dots > 0 || !symbol.change.empty();
}

/// `\grad f`, `\div(\mathbf A)`, `\curl\mathbf A`: the physics package.
SyntaxId Parser::field_function(Cursor& cursor, std::string_view name) {
  const Token token = cursor.token();
  const std::size_t at = skip_narrow(cursor.tokens, cursor.at + 1);
  ++cursor.at;
  const bool missing = at >= cursor.tokens.size();
  const bool divided = is_control(token, "div") && !missing && !opens_bracket(cursor.tokens[at]) &&
                       !is_bold(cursor.tokens, at) && !is_control(cursor.tokens[at], "qty");
  if (divided) return opaque(token.span, "`\\div` is read before a vector or a bracket only");
  cursor.at = at;
  if (missing || starts_sign(cursor) || factor_joint(cursor.token()) != Joint::none)
    return opaque(token.span, fmt::format("`\\{}` has nothing behind it to act on", token.text));
  const SyntaxId argument = opens_bracket(cursor.token()) ? bracket_argument(cursor) : factor(cursor);
  return tree_.add_named(SyntaxKind::function, cover(token.span, tree_[argument].span), std::string(name),
                         argument);
}

}  // namespace rigor
