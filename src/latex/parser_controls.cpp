// SPDX-License-Identifier: GPL-3.0-or-later
// Controls: fractions, roots, sums, braces with words, and whatever is not read yet.
#include <fmt/format.h>

#include "latex/cover_tokens.h"
#include "latex/parse_indices.h"
#include "latex/parser.h"

namespace rigor {
SyntaxId Parser::control(Cursor& cursor) {
  const Token token = cursor.token();
  const std::string_view name = token.text;
  if (is_fraction(token)) return fraction(cursor);
  if (name == "sqrt") return root(cursor);
  if (name == "dv" || name == "derivative") return physics_derivative(cursor, false);
  if (name == "pdv" || name == "partialderivative") return physics_derivative(cursor, true);
  if (name == "int" || name == "iiint") return integral(cursor);
  if (const auto known = function_name(name); !known.empty()) return function(cursor, known);
  if (field_operator(name)) return field_function(cursor, name);
  if (dots_of(token) > 0) return dotted(cursor);
  if (name == "sum") return big_sum(cursor);
  if (starts_quantity(cursor)) return quantity(cursor);
  if (name == "abs" || name == "norm" || name == "qty" || name == "quantity" || name == "absolutevalue")
    return braced_bracket(cursor);
  if (name == "lvert" || name == "lVert" || name == "|" || name == "Vert" || name == "vert")
    return bars(cursor);
  if (name == "{" || name == "lbrace") return bracketed(cursor);
  if (name == "begin") return environment(cursor);
  if (!letter_of(token).empty() || name == "nabla") return letter(cursor);
  if (const auto style = style_of(token)) return styled(cursor, *style);
  if (name == "textcolor" || name == "color") {
    ++cursor.at;
    return opaque(token.span, "colour is not read here");
  }
  if (is_transparent(token)) {
    const Argument argument = argument_at(cursor.tokens, cursor.at + 1);
    cursor.at = argument.next;
    return inner(argument.content, token.span);
  }
  if (name == "underbrace" || name == "overbrace" || name == "underset" || name == "overset" ||
      name == "stackrel") {
    return annotated(cursor);
  }
  if (is_words(token)) {
    const Argument words = argument_at(cursor.tokens, cursor.at + 1);
    cursor.at = words.next;
    return opaque(cover(token.span, words.content),
                  fmt::format("the words `{}` stand for a quantity", text_of(words.content)));
  }
  ++cursor.at;
  if (name == "rvert" || name == "rVert" || name == "}" || name == "rbrace") {
    return opaque(token.span, "this bar or brace closes nothing");
  }
  const std::string_view reason = unread_reason(name);
  // The argument of such a control goes with it; one obstacle is enough.
  if (name.ends_with("cancel")) cursor.at = argument_at(cursor.tokens, cursor.at).next;
  if (!reason.empty()) return opaque(token.span, fmt::format("`\\{}`: {}", name, reason));
  return opaque(token.span, fmt::format("`\\{}` is not known", name), DiagnosticKind::unsupported,
                {"if it is a macro of your own, its definition was not seen"});
}

/// What is written under a brace never changes an expression. Arrows over a letter make a vector or a tensor;
/// other signs over a letter are not read.
SyntaxId Parser::annotated(Cursor& cursor) {
  const Token token = cursor.token();
  const Argument first = argument_at(cursor.tokens, cursor.at + 1);
  if (token.text == "underbrace" || token.text == "overbrace") {
    cursor.at = first.next;
    const SyntaxId inside = inner(first.content, token.span);
    const std::size_t script = skip_blank(cursor.tokens, cursor.at);
    if (script < cursor.tokens.size() && (cursor.tokens[script].kind == TokenKind::subscript ||
                                          cursor.tokens[script].kind == TokenKind::superscript)) {
      cursor.at = script_argument_at(cursor.tokens, script + 1).next;
    }
    return tree_.add(SyntaxKind::group, tree_[inside].span, std::vector<SyntaxChild>{{inside}});
  }
  const Argument second = argument_at(cursor.tokens, first.next);
  cursor.at = second.next;
  const SyntaxId inside = inner(second.content, token.span);
  const std::string sign = text_of(first.content);
  const Span span = cover(token.span, tree_[inside].span);
  if (token.text != "underset" && sign == "\\leftrightarrow")
    return restyle(inside, {.face = Face::tensor}, span);
  if (token.text != "underset" && (sign == "\\rightarrow" || sign == "\\to"))
    return restyle(inside, {.face = Face::vector}, span);
  return opaque(span, fmt::format("`{}` over or under an expression is not read", sign));
}

SyntaxId Parser::fraction(Cursor& cursor) {
  const Token token = cursor.token();
  const Argument numerator = argument_at(cursor.tokens, cursor.at + 1);
  const Argument denominator = argument_at(cursor.tokens, numerator.next);
  Span span = cover(token.span, span_of(cursor.tokens.subspan(cursor.at, denominator.next - cursor.at)));
  cursor.at = denominator.next;
  if (is_derivative(numerator.content, denominator.content))
    return derivative_fraction(cursor, numerator.content, denominator.content, span);
  const SyntaxChild children[] = {{inner(numerator.content, span)}, {inner(denominator.content, span)}};
  return tree_.add(SyntaxKind::fraction, span, children);
}

SyntaxId Parser::root(Cursor& cursor) {
  const Token token = cursor.token();
  const Argument degree = optional_argument_at(cursor.tokens, cursor.at + 1);
  const Argument radicand = argument_at(cursor.tokens, degree.next);
  const Span span = cover(token.span, span_of(cursor.tokens.subspan(cursor.at, radicand.next - cursor.at)));
  cursor.at = radicand.next;
  if (!degree.content.empty() && text_of(degree.content) != "2")
    return opaque(span, "only square roots are read");
  const SyntaxChild child{inner(radicand.content, span)};
  return tree_.add(SyntaxKind::root, span, {&child, 1});
}

SyntaxId Parser::big_sum(Cursor& cursor) {
  const Token token = cursor.token();
  ++cursor.at;
  Tokens lower;
  Tokens upper;
  while (true) {
    cursor.skip_spacing();  // \limits among them
    if (cursor.done()) break;
    const TokenKind kind = cursor.token().kind;
    if (kind != TokenKind::subscript && kind != TokenKind::superscript) break;
    const ScriptArgument argument = script_argument_at(cursor.tokens, cursor.at + 1);
    (kind == TokenKind::subscript ? lower : upper).assign(argument.content.begin(), argument.content.end());
    cursor.at = argument.next;
  }
  const SumReading reading = read_sum_bounds(lower, upper);
  if (cursor.done()) return opaque(token.span, "the sum has no summand", DiagnosticKind::bad_syntax);
  const SyntaxId body = term(cursor);
  if (reading.obstacle) return tree_.add_opaque(token.span, *reading.obstacle);
  return tree_.add_big_sum(cover(token.span, tree_[body].span), reading.sum, body);
}

SyntaxId Parser::braced_bracket(Cursor& cursor) {
  const Token token = cursor.token();
  std::size_t at = skip_blank(cursor.tokens, cursor.at + 1);
  if (at < cursor.tokens.size() && is_sign(cursor.tokens[at], "*")) at = skip_blank(cursor.tokens, at + 1);
  if (at < cursor.tokens.size() && cursor.tokens[at].kind != TokenKind::begin_group &&
      token.text.starts_with("q")) {
    cursor.at = at;
    return factor(cursor);  // \qty(…): the bracket is an ordinary one
  }
  const Argument argument = argument_at(cursor.tokens, at);
  const Span span = cover(token.span, span_of(cursor.tokens.subspan(cursor.at, argument.next - cursor.at)));
  cursor.at = argument.next;
  const SyntaxKind kind = token.text.starts_with("a") ? SyntaxKind::bars
                          : token.text == "norm"      ? SyntaxKind::norm
                                                      : SyntaxKind::group;
  const SyntaxChild child{inner(argument.content, span)};
  return tree_.add(kind, span, {&child, 1});
}

}  // namespace rigor
