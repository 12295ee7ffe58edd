// SPDX-License-Identifier: GPL-3.0-or-later
// Words inside an expression, and letters that act on what comes after them.
#include <fmt/format.h>

#include <utility>

#include "base/among.h"
#include "latex/parse/parser.h"
#include "latex/split/acting.h"
#include "latex/token/cover_tokens.h"
#include "latex/token/differential.h"

namespace rigor {
namespace {

bool opens_bracket(const Token& token) { return is_sign_of(token, "(["); }

}  // namespace

/// `O(x^2)`, `Df/Dt`, `\mathrm d(xy)`, `\text{sin}`, `{\rm grad}`; nothing for other signs.
std::optional<SyntaxId> Parser::acts(Cursor& cursor) {
  const TokenView tokens = cursor.tokens;
  const std::size_t begin = cursor.at;
  const auto unread_until = [&](std::size_t end, const char* reason) {
    cursor.at = end;
    return opaque(span_of(tokens.subspan(begin, end - begin)), reason);
  };
  if (const std::size_t end = landau_end(tokens, begin); end != begin) {
    if (const auto node = landau(cursor, end)) return node;
    return unread_until(end, "`O(…)` says up to which order, or names a group; that is not decided yet");
  }
  if (const std::size_t end = material_end(tokens, begin); end != begin) {
    if (const auto node = slash_material(cursor, end)) return node;
    return unread_until(end, "this derivative along a motion is not decided");
  }
  if (is_lone_differential(tokens, begin)) {
    const Differential mark = *differential_at(tokens, begin);
    if (mark.partial || mark.order != 1)
      return unread_until(mark.next, "a differential by itself is not read");
    return lone_differential(cursor, mark.next);
  }
  const auto word = upright_word_at(tokens, begin);
  if (!word) return std::nullopt;
  if (const auto known = function_name(word->word); !known.empty())
    return function(cursor, known, word->next);
  if (field_operator(word->word) || word->word == "rot") return field_word(cursor, word->word, word->next);
  return std::nullopt;
}

/// `\mathrm dS`, `\mathrm d(pV)`: a derivative by nothing that is written.
SyntaxId Parser::lone_differential(Cursor& cursor, std::size_t behind) {
  const std::size_t begin = std::exchange(cursor.at, behind);
  const Span sign = span_of(cursor.tokens.subspan(begin, behind - begin));
  read_since(cursor, begin);
  cursor.at = skip_narrow(cursor.tokens, cursor.at);
  const SyntaxId operand = factor(cursor);
  const Span span = cover(sign, tree_[operand].span);
  const SyntaxKind kind = tree_[operand].kind;
  if (kind != SyntaxKind::symbol && kind != SyntaxKind::group && kind != SyntaxKind::opaque)
    return opaque(span, "a differential of this is not read", DiagnosticKind::unsupported,
                  {"brackets show how far it reaches: `\\mathrm d(x^2)`"});
  return tree_.add_derivative(span, {}, operand);
}

/// `O(x)`, `O(x^2)`: a function of that name. Nothing for what names no power of a letter.
std::optional<SyntaxId> Parser::landau(Cursor& cursor, std::size_t end) {
  const TokenView tokens = cursor.tokens;
  const std::size_t begin = cursor.at;
  const auto argument = landau_argument(tokens, begin, end);
  if (!argument || trim(*argument).empty()) return std::nullopt;
  const Span span = span_of(tokens.subspan(begin, end - begin));
  const SyntaxId power = inner(*argument, span);
  const bool raised =
      tree_[power].kind == SyntaxKind::power && tree_[tree_.child(power, 1)].kind == SyntaxKind::number;
  const SyntaxId base = raised ? tree_.child(power, 0) : power;
  if (tree_[base].kind != SyntaxKind::symbol) return std::nullopt;
  const auto inside = static_cast<std::size_t>(argument->data() - tokens.data());
  read(tokens.subspan(begin, inside - begin));
  read(tokens.subspan(inside + argument->size(), end - inside - argument->size()));
  cursor.at = end;
  return tree_.add_named(SyntaxKind::function, span, "O", power);
}

SyntaxId Parser::material_of(SyntaxId operand, Span span) {
  if (tree_[operand].kind == SyntaxKind::opaque) return operand;
  if (!is_one_factor(operand)) return unclear_operand(span);
  return tree_.add_named(SyntaxKind::function, span, "D/Dt", operand);
}

/// `\frac{Df}{Dt}`, `\frac{D}{Dt}(fg)`: a function of that name. The cursor is after the fraction.
SyntaxId Parser::material(Cursor& cursor, TokenView above, TokenView below, Span span) {
  const auto operand = material_operand(above, below);
  if (!operand) return opaque(span, "this derivative along a motion is not decided");
  read(above.first(above.size() - operand->size()));
  read(below);
  if (!operand->empty()) return material_of(inner(*operand, span), span);
  const SyntaxId rate = operate(cursor, {}, span);
  return tree_[rate].kind == SyntaxKind::derivative ? material_of(tree_.child(rate, 0), tree_[rate].span)
                                                    : rate;
}

/// `Df/Dt`, of one factor.
std::optional<SyntaxId> Parser::slash_material(Cursor& cursor, std::size_t end) {
  const TokenView written = cursor.tokens.subspan(cursor.at, end - cursor.at);
  Nesting nesting(false);
  std::size_t slash = 0;
  for (std::size_t at = 0; at < written.size(); ++at) {
    if (nesting.enter(written[at]) == 0 && is_sign(written[at], "/")) slash = at;
  }
  const auto operand = material_operand(written.first(slash), written.subspan(slash + 1));
  if (!operand || trim(*operand).empty()) return std::nullopt;
  const Span span = span_of(written);
  read(written.first(slash - operand->size()));
  read(written.subspan(slash));
  cursor.at = end;
  return material_of(inner(*operand, span), span);
}

/// `\operatorname{grad} f`, `\text{div}(f\mathbf A)`: sure where a bracket or nothing but one factor stands
/// after the word.
SyntaxId Parser::field_word(Cursor& cursor, const std::string& word, std::size_t behind) {
  const Span place = span_of(cursor.tokens.subspan(cursor.at, behind - cursor.at));
  const std::size_t begin = std::exchange(cursor.at, behind);
  read_since(cursor, begin);
  cursor.at = skip_narrow(cursor.tokens, cursor.at);
  if (cursor.done() || starts_sign(cursor) || factor_joint(cursor.token()) != Joint::none)
    return opaque(place, fmt::format("`{}` has nothing after it to act on", word));
  const bool bracket = opens_bracket(cursor.token());
  const SyntaxId argument = bracket ? bracket_argument(cursor) : factor(cursor);
  const Span span = cover(place, tree_[argument].span);
  const std::size_t next = skip_narrow(cursor.tokens, cursor.at);
  bool more = next < cursor.tokens.size();
  if (more) {
    const Token& token = cursor.tokens[next];
    const bool script = token.kind == TokenKind::superscript || token.kind == TokenKind::subscript;
    const bool sign = is_sign_of(token, "+-") || token.text == "−";
    const bool measure = measure_ != nullptr && differential_at(cursor.tokens, next);
    more = bracket ? script : !sign && !measure;
  }
  if (more || (!bracket && tree_[argument].kind == SyntaxKind::power)) return unclear_operand(span);
  const bool of_vector = is_one_of(word, {"div", "divergence", "rot", "curl"});
  if (of_vector && tree_[argument].kind == SyntaxKind::symbol && tree_.symbol(argument).face == Face::plain &&
      tree_.symbol(argument).accent != Accent::hat)
    return opaque(span, fmt::format("`{}` of a letter that is not bold is not read", word));
  return tree_.add_named(SyntaxKind::function, span, word == "rot" ? "curl" : word, argument);
}

/// `\text{…}` inside an expression: mathematics, a letter in bold or upright, or words that nobody reads.
SyntaxId Parser::words(Cursor& cursor) {
  const Token token = cursor.token();
  const Argument argument = argument_at(cursor.tokens, cursor.at + 1);
  const Span span = cover(token.span, cursor.tokens.subspan(cursor.at, argument.next - cursor.at));
  cursor.at = argument.next;
  const TokenView content = trim(argument.content);
  if (const auto mathematics = mathematics_in(content)) {
    read(content.first(1));
    read(content.last(1));
    return inner(*mathematics, span);
  }
  const bool typed = token.text == "texttt" || token.text == "textsc" || token.text == "fbox";
  if (content.size() == 1 && !letter_of(content[0]).empty() && !typed) {
    const bool italic = token.text == "textit" || token.text == "emph";
    const Style style{.face = token.text == "textbf"   ? Face::vector
                              : token.text == "textsf" ? Face::tensor
                                                       : Face::plain,
                      .upright = !italic && token.text != "textbf" && token.text != "textsf"};
    return restyle(inner(content, span), style, span);
  }
  return opaque(span, fmt::format("the words `{}` stand for a quantity, or act on one", text_of(content)),
                DiagnosticKind::passed_over);
}

}  // namespace rigor
