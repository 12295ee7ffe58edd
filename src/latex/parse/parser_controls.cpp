// SPDX-License-Identifier: GPL-3.0-or-later
// Controls: fractions, roots, sums, braces with words, and whatever is not read yet.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "base/among.h"
#include "base/ascii.h"
#include "latex/parse/parse_indices.h"
#include "latex/parse/parser.h"
#include "latex/split/acting.h"
#include "latex/split/beside.h"
#include "latex/split/conditions.h"
#include "latex/token/cover_tokens.h"
#include "latex/token/differential.h"
#include "latex/token/remarks.h"

namespace rigor {
namespace {

/// What is at a brace: a name, `F`, `\mathbf L_{\text{orb}}`, `\text{kinetic energy}`; words that may say
/// more, `\text{dropped below}`; or a number or a relation, which do.
enum class BraceLabel : std::uint8_t { name, words, statement };

BraceLabel brace_label(TokenView label) {
  const bool related = std::ranges::any_of(label, [](const Token& token) {
    return relation_kind(token).has_value() || is_control(token, "downarrow");
  });
  if (related) return BraceLabel::statement;
  const bool worded = std::ranges::any_of(label, is_words);
  const bool symbol = !trim(label).empty() && symbol_end(label, skip_narrow(label, 0)) == label.size();
  if (worded && !symbol) {
    const std::string words = spoken(label);
    if (remark_of(words) == Remark::remark) return BraceLabel::name;
    const bool plain = std::ranges::all_of(words, [](char c) {
      return is_letter(c) || is_white(c) || c == '-' || c == ',' || c == '.' || c == '\'';
    });
    return plain ? BraceLabel::words : BraceLabel::statement;
  }
  const bool named = std::ranges::any_of(label, [](const Token& token) { return !letter_of(token).empty(); });
  return named ? BraceLabel::name : BraceLabel::statement;
}

}  // namespace

SyntaxId Parser::control(Cursor& cursor) {
  const Token token = cursor.token();
  const std::string_view name = token.text;
  read_sign(cursor);
  if (is_fraction(token)) return fraction(cursor);
  if (name == "sqrt") return root(cursor);
  if (name == "dv" || name == "derivative") return physics_derivative(cursor, false);
  if (name == "pdv" || name == "partialderivative") return physics_derivative(cursor, true);
  if (name == "int" || name == "iiint") return integral(cursor);
  if (const auto known = function_name(name); !known.empty()) return function(cursor, known, cursor.at + 1);
  if (field_operator(name)) return field_function(cursor, name);
  if (dots_of(token) > 0) return dotted(cursor);
  if (name == "sum") return big_sum(cursor);
  if (starts_quantity(cursor)) return quantity(cursor);
  if (is_one_of(name, {"abs", "norm", "qty", "quantity", "absolutevalue"})) return braced_bracket(cursor);
  if (is_one_of(name, {"lvert", "lVert", "|", "Vert", "vert"})) return bars(cursor);
  if (const auto states = state_bracket(cursor)) return *states;
  if (const auto pair = pair_in_brackets(cursor)) return *pair;
  if (const auto mean = expectation(cursor)) return *mean;
  if (name == "{" || name == "lbrace") return bracketed(cursor);
  if (name == "begin") return environment(cursor);
  if (!letter_of(token).empty() || name == "nabla") return letter(cursor);
  if (const auto style = style_of(token)) return styled(cursor, *style);
  if (name == "textcolor" || name == "color") {
    ++cursor.at;
    return opaque(token.span, "colour is not read here");
  }
  if (is_one_of(name, {"cancel", "bcancel", "xcancel"})) return struck(cursor);
  if (name == "cancelto") return struck_to(cursor);
  if (is_transparent(token)) {
    const Argument argument = argument_at(cursor.tokens, cursor.at + 1);
    cursor.at = argument.next;
    return inner(argument.content, token.span);
  }
  if (is_one_of(name, {"underbrace", "overbrace", "underset", "overset", "stackrel"})) {
    return name.ends_with("brace") ? braced(cursor) : annotated(cursor);
  }
  if (is_words(token)) return words(cursor);
  ++cursor.at;
  if (is_one_of(name, {"rvert", "rVert", "}", "rbrace"})) {
    return opaque(token.span, "this bar or brace closes nothing");
  }
  const std::string_view reason = unread_reason(name);
  if (!reason.empty()) return opaque(token.span, fmt::format("`\\{}`: {}", name, reason));
  return opaque(token.span, fmt::format("`\\{}` is not known", name), DiagnosticKind::unsupported,
                {"if it is a macro of your own, its definition was not seen"});
}

/// What a brace says about the part that it holds: a name for it, kept as `text`. Words that are no remark
/// may restrict the statement, which is then not refuted. Zero or a relation (`>0`) is an assumption of the
/// chain (see conditions.h).
SyntaxId Parser::braced(Cursor& cursor) {
  const Token token = cursor.token();
  const Argument part = argument_at(cursor.tokens, cursor.at + 1);
  cursor.at = part.next;
  std::vector<SyntaxChild> children{{inner(part.content, token.span)}};
  const Span span = tree_[children[0].id].span;
  const std::size_t script = skip_blank(cursor.tokens, cursor.at);
  const bool labelled =
      script < cursor.tokens.size() && (cursor.tokens[script].kind == TokenKind::subscript ||
                                        cursor.tokens[script].kind == TokenKind::superscript);
  if (labelled) {
    const Argument label = script_argument_at(cursor.tokens, script + 1);
    cursor.at = label.next;
    BraceLabel kind = brace_label(label.content);
    if (kind == BraceLabel::statement && said_at_brace(part.content, label.content)) kind = BraceLabel::name;
    if (kind == BraceLabel::statement)
      return opaque(
          cover(span, span_of(label.content)),
          fmt::format("what `{}` says about the part at its brace is not read", text_of(label.content)),
          DiagnosticKind::passed_over);
    read_since(cursor, script);
    const Span place = span_of(label.content);
    const std::string text = text_of(label.content);
    if (kind == BraceLabel::words) {
      children.push_back({opaque(place, fmt::format("`{}` may restrict the part at its brace", text),
                                 DiagnosticKind::restricted)});
    } else {
      children.push_back({tree_.add_text(SyntaxKind::text, place, text)});
    }
  }
  return tree_.add(SyntaxKind::group, span, children);
}

/// Arrows over a letter make a vector or a tensor; other signs over a letter are not read.
SyntaxId Parser::annotated(Cursor& cursor) {
  const Token token = cursor.token();
  const Argument first = argument_at(cursor.tokens, cursor.at + 1);
  const Argument second = argument_at(cursor.tokens, first.next);
  cursor.at = second.next;
  const SyntaxId inside = inner(second.content, token.span);
  const std::string sign = text_of(first.content);
  const Span span = cover(token.span, tree_[inside].span);
  read(first.content);
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
  if (is_material(numerator.content, denominator.content))
    return material(cursor, numerator.content, denominator.content, span);
  if (is_derivative(numerator.content, denominator.content))
    return derivative_fraction(cursor, numerator.content, denominator.content, span);
  const SyntaxChild children[] = {{with_measure(numerator.content, span)},
                                  {inner(denominator.content, span)}};
  return tree_.add(SyntaxKind::fraction, span, children);
}

SyntaxId Parser::root(Cursor& cursor) {
  const Token token = cursor.token();
  const Argument degree = optional_argument_at(cursor.tokens, cursor.at + 1);
  const Argument radicand = script_argument_at(cursor.tokens, degree.next);  // also `\sqrt\frac km`
  const Span span = cover(token.span, span_of(cursor.tokens.subspan(cursor.at, radicand.next - cursor.at)));
  read(cursor.tokens.subspan(cursor.at, degree.next - cursor.at));
  cursor.at = radicand.next;
  if (!degree.content.empty() && text_of(degree.content) != "2")
    return opaque(span, "only square roots are read");
  const SyntaxChild child{inner(radicand.content, span)};
  return tree_.add(SyntaxKind::root, span, {&child, 1});
}

/// `-a_i` of `\sum_i -a_i`
SyntaxId Parser::signed_summand(Cursor& cursor) {
  const Span place = cursor.token().span;
  const Joint sign = *sign_joint(cursor.token());
  read_sign(cursor);
  ++cursor.at;
  cursor.skip_spacing();
  if (cursor.done()) return opaque(place, "an operand is missing after the sign", DiagnosticKind::bad_syntax);
  const SyntaxChild child{term(cursor), sign, place};
  return tree_.add(SyntaxKind::sum, cover(place, tree_[child.id].span), {&child, 1});
}

SyntaxId Parser::big_sum(Cursor& cursor) {
  const Token token = cursor.token();
  ++cursor.at;
  TokenView lower;
  TokenView upper;
  bool again = false;  // two subscripts, or two superscripts
  while (true) {
    cursor.skip_spacing();  // \limits among them
    if (cursor.done()) break;
    const TokenKind kind = cursor.token().kind;
    if (kind != TokenKind::subscript && kind != TokenKind::superscript) break;
    const Argument argument = script_argument_at(cursor.tokens, cursor.at + 1);
    TokenView& bound = kind == TokenKind::subscript ? lower : upper;
    again = again || bound.data() != nullptr;
    bound = argument.content;
    read(cursor.tokens.subspan(cursor.at, argument.next - cursor.at));
    cursor.at = argument.next;
  }
  const SumReading reading = read_sum_bounds(lower, upper);
  if (cursor.done()) return opaque(token.span, "the sum has no summand", DiagnosticKind::bad_syntax);
  const SyntaxId body = sign_joint(cursor.token()) ? signed_summand(cursor) : term(cursor);
  if (again) return opaque(token.span, "the sum has two bounds on one side", DiagnosticKind::bad_syntax);
  if (reading.obstacle) return tree_.add_opaque(token.span, *reading.obstacle);
  const Span span = cover(token.span, tree_[body].span);
  const auto equals = std::ranges::find_if(lower, [](const Token& each) { return is_sign(each, "="); });
  const bool limits = equals != lower.end() && !trim(upper).empty();
  const auto counted = [](const std::string& text) {
    return std::ranges::all_of(text, [](char each) { return each >= '0' && each <= '9'; });
  };
  const bool plain = counted(reading.sum.from) && (counted(reading.sum.to) || reading.sum.to == "N");
  if (!limits || plain) return tree_.add_big_sum(span, reading.sum, body);
  const SyntaxChild children[] = {
      {body}, {limit(TokenView(equals + 1, lower.end()), token.span)}, {limit(upper, token.span)}};
  return tree_.add_big_sum(span, reading.sum, children);
}

SyntaxId Parser::braced_bracket(Cursor& cursor) {
  const Token token = cursor.token();
  std::size_t at = skip_blank(cursor.tokens, cursor.at + 1);
  if (is_sign_at(cursor.tokens, at, "*")) {
    read(cursor.tokens.subspan(at, 1));
    at = skip_blank(cursor.tokens, at + 1);
  }
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
