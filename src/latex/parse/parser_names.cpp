// SPDX-License-Identifier: GPL-3.0-or-later
// Letters, words and numbers: the leaves of an expression.
#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "latex/parse/parse.h"
#include "latex/parse/parser.h"
#include "latex/token/cover_tokens.h"
#include "latex/token/differential.h"

namespace rigor {
namespace {

/// `\delta\mathbf A`, `\Delta x`: a letter follows directly, bare, styled or alone in braces.
bool starts_change(TokenView tokens, std::size_t at) {
  const std::string letter = letter_of(tokens[at]);
  if (letter != "\\delta" && letter != "\\Delta") return false;
  const std::size_t next = skip_blank(tokens, at + 1);
  if (next >= tokens.size()) return false;
  if (tokens[next].kind != TokenKind::begin_group) return symbol_end(tokens, next) != next;
  const TokenView content = trim(argument_at(tokens, next).content);
  return !content.empty() && symbol_end(content, 0) == content.size();
}

bool all_plain_letters(TokenView tokens) {
  return tokens.size() > 1 && std::ranges::all_of(tokens, [](const Token& token) {
           return token.kind == TokenKind::letter && token.text.size() == 1;
         });
}

/// Names of packages, and short names that authors give to macros of their own: `\vu = …`, where `\vu` is a
/// vector.
bool may_be_a_macro_of_the_author(std::string_view name) {
  static const WordSet names("vu vb va vv bm tensor");
  return names.contains(name);
}

bool can_be_an_argument(TokenView tokens, std::size_t at) {
  if (at >= tokens.size() || relation_kind(tokens[at]) || factor_joint(tokens[at]) != Joint::none)
    return false;
  const TokenKind kind = tokens[at].kind;
  return kind == TokenKind::letter || kind == TokenKind::digit || kind == TokenKind::begin_group ||
         kind == TokenKind::control;
}

}  // namespace

SyntaxId Parser::number(Cursor& cursor) {
  std::string digits;
  Span span = cursor.token().span;
  bool point = false;
  while (!cursor.done()) {
    const Token& token = cursor.token();
    const bool is_point = is_sign(token, ".") && !point && cursor.at + 1 < cursor.tokens.size() &&
                          cursor.tokens[cursor.at + 1].kind == TokenKind::digit;
    if (token.kind != TokenKind::digit && !is_point) break;
    point = point || is_point;
    read_sign(cursor);
    digits += token.text;
    span = cover(span, token.span);
    ++cursor.at;
  }
  if (digits.front() == '.') digits.insert(0, "0");
  return tree_.add_text(SyntaxKind::number, span, std::move(digits));
}

SyntaxId Parser::asked(Cursor& cursor) {
  const Span place = cursor.token().span;
  read_sign(cursor);
  ++cursor.at;
  WrittenSymbol symbol;
  symbol.letter = hole_letter;
  symbol.letter_span = place;
  return tree_.add_symbol(place, std::move(symbol));
}

/// `\Box A^\mu` is a derivative by `x_\Box`: in space-time it is \partial_\mu\partial^\mu.
SyntaxId Parser::box_operator(Cursor& cursor, SyntaxId box, Span place) {
  const bool bare = tree_[box].kind == SyntaxKind::symbol && tree_.symbol(box).letter == hole_letter;
  if (!bare) return opaque(tree_[box].span, "d'Alembert's operator in a bracket or to a power is not read");
  WrittenVariable variable;
  variable.symbol.letter = "x";
  variable.symbol.letter_span = place;
  variable.symbol.lower.push_back({box_letter, IndexForm::word, 0, place});
  cursor.skip_spacing();
  const SyntaxId operand = factor(cursor);
  cursor.skip_spacing();
  const Span whole = cover(place, tree_[operand].span);
  if (!cursor.done() && !starts_sign(cursor) && factor_joint(cursor.token()) == Joint::none)
    return unclear_operand(whole);
  return tree_.add_derivative(whole, {true, {std::move(variable)}}, operand);
}

SyntaxId Parser::letter(Cursor& cursor) {
  const Token token = cursor.token();
  read_sign(cursor);
  if (starts_change(cursor.tokens, cursor.at)) return changed(cursor);
  ++cursor.at;
  const bool nabla = is_control(token, "nabla") || token.text == "∇";
  std::string letter = nabla ? "\\nabla" : letter_of(token);
  if (letter.empty()) return opaque(token.span, fmt::format("the sign `{}` is not read", token.text));
  WrittenSymbol symbol;
  symbol.letter = std::move(letter);
  if (nabla) symbol.face = Face::vector;
  symbol.letter_span = token.span;
  return tree_.add_symbol(token.span, std::move(symbol));
}

/// A change of a quantity is one symbol.
SyntaxId Parser::changed(Cursor& cursor) {
  const Token token = cursor.token();
  if (depth_ >= max_nesting) {
    cursor.at = cursor.tokens.size();
    return opaque(token.span, "changes nest too deep", DiagnosticKind::nesting_too_deep);
  }
  cursor.at = skip_blank(cursor.tokens, cursor.at + 1);
  ++depth_;
  const SyntaxId inside = primary(cursor);
  --depth_;
  const Span span = cover(token.span, tree_[inside].span);
  if (tree_[inside].kind == SyntaxKind::opaque) return inside;
  if (tree_[inside].kind != SyntaxKind::symbol || !tree_.symbol(inside).change.empty())
    return opaque(span, fmt::format("`{}` before this is not read", text_of({&token, 1})));
  WrittenSymbol symbol = tree_.symbol(inside);
  symbol.change = letter_of(token);
  symbol.letter_span = cover(token.span, symbol.letter_span);
  return tree_.add_symbol(span, std::move(symbol));
}

bool Parser::starts_accent(TokenView tokens, std::size_t at) {
  return at < tokens.size() && (style_of(tokens[at]).has_value() || dots_of(tokens[at]) > 0);
}

/// `\hat\mathbf n`, `\mathbf\dot r`: the inner one of two accents.
SyntaxId Parser::nested_accent(Cursor& cursor) {
  if (depth_ >= max_nesting) {
    const Span place = cursor.token().span;
    cursor.at = cursor.tokens.size();
    return opaque(place, "accents nest too deep", DiagnosticKind::nesting_too_deep);
  }
  ++depth_;
  const auto style = style_of(cursor.token());
  const SyntaxId inside = style ? styled(cursor, *style) : dotted(cursor);
  --depth_;
  return inside;
}

SyntaxId Parser::styled(Cursor& cursor, Style style) {
  const Token token = cursor.token();
  const std::size_t begin = cursor.at;
  std::size_t at = cursor.at + 1;
  if (is_sign_at(cursor.tokens, at, "*")) ++at;  // \vb*{…}: italic bold
  read(cursor.tokens.subspan(begin, at - begin));
  at = skip_blank(cursor.tokens, at);
  if (starts_accent(cursor.tokens, at)) {
    cursor.at = at;
    const SyntaxId inside = nested_accent(cursor);
    return restyle(inside, style, cover(token.span, tree_[inside].span));
  }
  if (token.text == "bf" || token.text == "rm" || token.text == "bold") return switched(cursor, style, at);
  if (may_be_a_macro_of_the_author(token.text) && !can_be_an_argument(cursor.tokens, at)) {
    cursor.at = at;
    return opaque(token.span, fmt::format("`\\{}` without an argument is not read", token.text),
                  DiagnosticKind::unsupported, {"if it is a macro of your own, its definition was not seen"});
  }
  const Argument argument = argument_at(cursor.tokens, at);
  cursor.at = argument.next;
  const TokenView content = trim(argument.content);
  Span span = content.empty() ? token.span : cover(token.span, span_of(content));
  if (argument.next > 0 && argument.next <= cursor.tokens.size())
    span = cover(span, cursor.tokens[argument.next - 1].span);
  if (content.empty())
    return opaque(token.span, fmt::format("`\\{}` has no argument", token.text), DiagnosticKind::bad_syntax);
  if (all_plain_letters(content) && (style.face != Face::plain || style.upright)) {
    const std::string word = text_of(content);
    if (style.upright || !function_name(word).empty() || field_operator(word) || word == "rot") {
      return opaque(span, fmt::format("`{}` is a word, not a quantity that is known", word));
    }
    read(content);
    WrittenSymbol symbol;
    symbol.letter = word;
    symbol.face = style.face;
    symbol.letter_span = span;
    return tree_.add_symbol(span, std::move(symbol));
  }
  return restyle(inner(content, span), style, span);
}

/// `{\bf A}`: a switch holds to the end of its group, which must be one symbol.
SyntaxId Parser::switched(Cursor& cursor, Style style, std::size_t at) {
  const Token token = cursor.token();
  const TokenView rest = cursor.tokens.subspan(at);
  cursor.at = cursor.tokens.size();
  const Span span = cover(token.span, rest);
  const SyntaxId inside = inner(rest, span);
  if (tree_[inside].kind != SyntaxKind::symbol)
    return opaque(span, fmt::format("`\\{}` over more than one symbol is not read", token.text));
  return restyle(inside, style, span);
}

SyntaxId Parser::restyle(SyntaxId inside, Style style, Span span) {
  const SyntaxKind kind = tree_[inside].kind;
  if (kind == SyntaxKind::opaque) return inside;
  if (kind == SyntaxKind::number) {
    if (tree_.text(inside) == "0" || style.upright)
      return tree_.add_text(SyntaxKind::number, span, tree_.text(inside));
    if (tree_.text(inside) == "1" && style.alphabet == "mathbb")
      return tree_.add_symbol(span, {.letter = "\\mathbb{1}", .letter_span = span});
    return opaque(span, "a number in bold (a unit tensor, say) is not read yet");
  }
  const bool expression = kind == SyntaxKind::term || kind == SyntaxKind::sum || kind == SyntaxKind::power ||
                          kind == SyntaxKind::group || kind == SyntaxKind::fraction ||
                          kind == SyntaxKind::function;
  if (expression && style.accent == Accent::bar && style.face == Face::plain)
    return tree_.add_named(SyntaxKind::function, span, "bar", inside);
  if (kind != SyntaxKind::symbol)
    return opaque(span, "a style or accent over a whole expression is not read");
  WrittenSymbol symbol = tree_.symbol(inside);
  if (style.face != Face::plain) symbol.face = style.face;
  if (style.accent != Accent::none) {
    if (symbol.dots > 0 || !symbol.change.empty())
      return opaque(span, "an accent over a derivative or a change is not read");
    if (symbol.accent != Accent::none) return opaque(span, "two accents on one letter are not read");
    symbol.accent = style.accent;
  }
  if (!style.alphabet.empty()) symbol.letter = fmt::format("\\{}{{{}}}", style.alphabet, symbol.letter);
  if (style.upright) symbol.letter = fmt::format("\\mathrm{{{}}}", symbol.letter);
  symbol.letter_span = span;
  return tree_.add_symbol(span, std::move(symbol));
}

}  // namespace rigor
