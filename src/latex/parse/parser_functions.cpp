// SPDX-License-Identifier: GPL-3.0-or-later
// Functions and where their arguments end.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "base/among.h"
#include "latex/parse/parser.h"
#include "latex/token/differential.h"

namespace rigor {
namespace {

bool is_bold(TokenView tokens, std::size_t at) {
  if (at >= tokens.size()) return false;
  const auto style = style_of(tokens[at]);
  return style && style->face != Face::plain;
}

bool opens_argument(const Token& token) {
  return is_sign_of(token, "([") || is_control(token, "{") || is_control(token, "lbrace") ||
         token.kind == TokenKind::begin_group;
}

/// One of the plain letters, numbers and fractions that an argument without brackets is made of.
bool is_plain_factor(TokenView tokens, std::size_t at) {
  const Token& token = tokens[at];
  if (token.kind == TokenKind::digit) return true;
  if (is_sign(token, ".")) return at + 1 < tokens.size() && tokens[at + 1].kind == TokenKind::digit;
  if (is_control_of(token, {"frac", "tfrac", "dfrac", "sqrt"})) return true;
  if (!letter_of(token).empty()) return true;
  const auto style = style_of(token);
  if (style && (style->face != Face::plain || style->upright)) return false;
  if (!style && dots_of(token) == 0) return false;
  const Argument argument = argument_at(tokens, at + 1);
  return std::ranges::none_of(argument.content, [](const Token& inside) {
    const auto face = style_of(inside);
    return face && face->face != Face::plain;
  });
}

/// `\hat r`: after a letter it is a vector or an operator, and no part of the argument.
bool is_hatted(const Token& token) {
  const auto style = style_of(token);
  return style && style->accent == Accent::hat;
}

/// May an argument end after this factor, though another letter follows? After an angle, `\cos\theta r`,
/// and before a blank that the author typed between two letters, `\exp a b`.
bool may_end(const SyntaxTree& tree, SyntaxId last, TokenView tokens, std::size_t at) {
  if (at >= tokens.size()) return false;
  const std::size_t next = skip_blank(tokens, at);
  if (next >= tokens.size() || letter_of(tokens[next]).empty()) return false;
  const bool symbol = tree[last].kind == SyntaxKind::symbol;
  if (symbol && is_usual_angle(tree.symbol(last).letter)) return true;
  return symbol && next != at && tokens[at - 1].kind == TokenKind::letter &&
         tokens[next].kind == TokenKind::letter;
}

/// `\cos\theta\,d m`: the differential of an integral is no part of the argument.
bool starts_differential(TokenView tokens, std::size_t at) {
  const auto mark = differential_at(tokens, at);
  return mark && symbol_end(tokens, mark->next) != mark->next;
}

/// `\sin[2](x)` of the physics package: the place behind it; `at` itself for anything else.
std::size_t behind_power_in_brackets(TokenView tokens, std::size_t at) {
  const Argument power = optional_argument_at(tokens, at);
  const TokenView content = trim(power.content);
  const std::size_t open = skip_blank(tokens, power.next);
  const bool is_power = power.next != at && content.size() == 1 && content[0].kind == TokenKind::digit;
  return is_power && is_sign_at(tokens, open, "(") ? bracket_end(tokens, open) : at;
}

}  // namespace

/// `behind`: the place behind the name as it is written.
SyntaxId Parser::function(Cursor& cursor, std::string_view name, std::size_t behind) {
  const Token token = cursor.token();
  const std::size_t begin = std::exchange(cursor.at, behind);
  read_since(cursor, begin);
  std::size_t script = skip_blank(cursor.tokens, cursor.at);
  if (const std::size_t end = behind_power_in_brackets(cursor.tokens, script); end != script) {
    cursor.at = end;
    const Span whole = span_of(cursor.tokens.subspan(begin, end - begin));
    return opaque(whole,
                  fmt::format("`{}` can be a power of `{}`, or a product with its value",
                              text_of(cursor.tokens.subspan(begin, end - begin)), name),
                  DiagnosticKind::ambiguous_reading);
  }
  std::optional<Argument> exponent;
  Span place;
  if (is_kind_at(cursor.tokens, script, TokenKind::superscript)) {
    exponent = script_argument_at(cursor.tokens, script + 1);
    place = span_of(cursor.tokens.subspan(script, exponent->next - script));
    read(cursor.tokens.subspan(script, 1));
    cursor.at = exponent->next;
    script = skip_blank(cursor.tokens, cursor.at);
  }
  // `\log_{10} x`, `\log_2 x`
  if (name == "log" && is_kind_at(cursor.tokens, script, TokenKind::subscript)) {
    const Argument base = script_argument_at(cursor.tokens, script + 1);
    const std::string digits = text_of(base.content);
    if (digits == "10" || digits == "2") {
      read(cursor.tokens.subspan(script, base.next - script));
      name = digits == "2" ? "lb" : "lg";
      cursor.at = base.next;
      script = skip_blank(cursor.tokens, cursor.at);
    }
  }
  const bool other = script < cursor.tokens.size() && (cursor.tokens[script].kind == TokenKind::subscript ||
                                                       is_sign(cursor.tokens[script], "'"));
  const std::size_t inside = cursor.at;
  SyntaxId argument = function_argument(cursor, token.span, name, begin);
  if (power_belongs(cursor, {name, begin, inside})) argument = scripts(cursor, argument);
  const Span span = cover(token.span, tree_[argument].span);
  if (other) return opaque(span, fmt::format("a subscript or superscript on `{}` is not read", name));
  if (exponent && text_of(exponent->content) == "-1")
    return opaque(span, fmt::format("`{}^{{-1}}` is an inverse function, or a power; it is not read", name));
  if (tree_[argument].kind == SyntaxKind::opaque) return argument;
  const SyntaxId node = tree_.add_named(SyntaxKind::function, span, std::string(name), argument);
  return exponent ? this->exponent(node, exponent->content, place) : node;
}

SyntaxId Parser::function_argument(Cursor& cursor, Span place, std::string_view name, std::size_t begin) {
  cursor.at = skip_narrow(cursor.tokens, cursor.at);
  if (!cursor.done() && cursor.token().kind == TokenKind::subscript)
    cursor.at = skip_narrow(cursor.tokens, script_argument_at(cursor.tokens, cursor.at + 1).next);
  if (cursor.done() || starts_sign(cursor) || factor_joint(cursor.token()) != Joint::none)
    return opaque(place, fmt::format("`{}` without an argument is not read", name));
  if (lifts_braces_of_argument(cursor, begin)) cursor.at = skip_narrow(cursor.tokens, cursor.at);
  if (opens_argument(cursor.token())) {
    const Application application{name, begin, cursor.at};
    const SyntaxId argument = bracket_argument(cursor);
    return letter_belongs(cursor, application, argument) ? with_letter(cursor, argument) : argument;
  }
  if (is_bold(cursor.tokens, cursor.at) || !is_plain_factor(cursor.tokens, cursor.at)) {
    const bool matrix_function = name == "det" || name == "tr";
    const SyntaxId argument = factor(cursor);
    const std::size_t next = skip_narrow(cursor.tokens, cursor.at);
    if (matrix_function && is_bold(cursor.tokens, next)) return unclear_argument(place, name);
    // `\Re\mathbf E_0 e^{i\omega t}`
    const bool part = name == "Re" || name == "Im";
    const bool more =
        next < cursor.tokens.size() &&
        (is_bold(cursor.tokens, next) || is_plain_factor(cursor.tokens, next) ||
         opens_argument(cursor.tokens[next]) || factor_joint(cursor.tokens[next]) != Joint::none);
    if (part && more) return unclear_argument(place, name);
    return argument;
  }
  return plain_argument(cursor, name, begin);
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
SyntaxId Parser::plain_argument(Cursor& cursor, std::string_view name, std::size_t begin) {
  const Application application{name, begin, cursor.at};
  std::vector<SyntaxChild> factors;
  bool asked = false;
  bool ended = false;
  Span span = cursor.token().span;
  while (true) {
    const std::size_t next = skip_blank(cursor.tokens, cursor.at);
    if (next >= cursor.tokens.size() || !is_plain_factor(cursor.tokens, next)) break;
    if (!factors.empty() && (starts_differential(cursor.tokens, next) || is_hatted(cursor.tokens[next])))
      break;
    if (!factors.empty() && !asked && may_end(tree_, factors.back().id, cursor.tokens, cursor.at)) {
      asked = true;
      ended = argument_ends(cursor, application);
      if (ended) break;
    }
    cursor.at = next;
    const Span joint = cursor.token().span;
    const SyntaxId node = factor(cursor);
    // `\cos\theta\dot\theta` and `\cos\theta\delta\theta` are products, `\sin\Omega\Delta t` is not.
    if (!factors.empty() && is_rate_or_change(node)) return unclear_argument(cover(span, joint), name);
    span = cover(span, tree_[node].span);
    factors.push_back({node, factors.empty() ? Joint::none : Joint::juxtaposed, joint});
  }
  // `\sin\theta/2` is read both ways.
  const std::size_t slash = skip_narrow(cursor.tokens, cursor.at);
  if (is_sign_at(cursor.tokens, slash, "/")) {
    const std::size_t below = skip_narrow(cursor.tokens, slash + 1);
    if (below < cursor.tokens.size() && is_plain_factor(cursor.tokens, below))
      return unclear_argument(span, name);
  }
  if (!ended && bracket_belongs(cursor, application)) {
    cursor.skip_spacing();
    const Span joint = cursor.token().span;
    factors.push_back({scripts(cursor, primary(cursor)), Joint::juxtaposed, joint});
    span = cover(span, tree_[factors.back().id].span);
  }
  return factors.size() == 1 ? factors[0].id : tree_.add(SyntaxKind::term, span, factors);
}

/// `\cos\theta r`: does the argument end where reading is, or go on with all the letters after?
bool Parser::argument_ends(const Cursor& cursor, const Application& application) {
  const TokenView tokens = cursor.tokens;
  std::size_t end = cursor.at;
  std::size_t behind = skip_blank(tokens, end);
  while (behind < tokens.size() && is_plain_factor(tokens, behind) && symbol_end(tokens, behind) != behind) {
    end = symbol_end(tokens, behind);
    behind = skip_blank(tokens, end);
  }
  const auto written = [&](std::size_t from, std::size_t to) {
    return text_of(tokens.subspan(from, to - from));
  };
  const std::string function = written(application.begin, application.argument);
  const Span span = cover(tokens[application.begin].span, tokens[std::max(end, cursor.at + 1) - 1].span);
  return takes_second({span, fmt::format("{}({})", function, written(application.argument, end)),
                       fmt::format("{}({}) {}", function, written(application.argument, cursor.at),
                                   written(cursor.at, end))});
}

/// `\cos(\omega + \Omega)t`, `\sin(n + 1)\theta`: is the letter after the bracket part of the angle? Nobody
/// puts a bracket around anything but a sum for that.
bool Parser::letter_belongs(const Cursor& cursor, const Application& application, SyntaxId argument) {
  static constexpr auto functions = std::to_array<std::string_view>({"sin", "cos", "tan", "cot"});
  static constexpr auto variables =
      std::to_array<std::string_view>({"t", "x", "y", "z", "\\theta", "\\phi", "\\varphi", "\\tau"});
  const TokenView tokens = cursor.tokens;
  const std::size_t at = skip_blank(tokens, cursor.at);
  const bool sum = tree_[argument].kind == SyntaxKind::sum && tree_[argument].count > 1;
  if (!sum || !is_one_of(application.name, functions) || at >= tokens.size() ||
      !is_one_of(std::string_view(letter_of(tokens[at])), variables))
    return false;
  const auto written = [&](std::size_t from, std::size_t to) {
    return text_of(tokens.subspan(from, to - from));
  };
  const std::string function = written(application.begin, application.argument);
  const std::string bracket = written(application.argument, cursor.at);
  const std::string letter = written(at, at + 1);
  return takes_second({cover(tokens[application.begin].span, tokens[at].span),
                       fmt::format("{}{} \\, {}", function, bracket, letter),
                       fmt::format("{}({} {})", function, bracket, letter)});
}

SyntaxId Parser::with_letter(Cursor& cursor, SyntaxId argument) {
  cursor.at = skip_blank(cursor.tokens, cursor.at);
  const Span joint = cursor.token().span;
  const SyntaxId letter = factor(cursor);
  const std::array factors{SyntaxChild{argument, Joint::none, tree_[argument].span},
                           SyntaxChild{letter, Joint::juxtaposed, joint}};
  return tree_.add(SyntaxKind::term, cover(tree_[argument].span, tree_[letter].span), factors);
}

/// `\cos\omega(t - t_0)`: is the bracket after the letters part of the argument? Not where functions,
/// vectors or commas are in it.
bool Parser::bracket_belongs(const Cursor& cursor, const Application& application) {
  const TokenView tokens = cursor.tokens;
  const std::size_t open = skip_narrow(tokens, cursor.at);
  const std::size_t end = bracket_end(tokens, open);
  if (end == open) return false;
  const TokenView content = tokens.subspan(open + 1, end - open - 2);
  const bool other = std::ranges::any_of(content, [](const Token& token) {
    const auto style = style_of(token);
    const bool control = token.kind == TokenKind::control;
    return is_sign(token, ",") || (control && !function_name(token.text).empty()) ||
           (style && (style->face != Face::plain || style->accent == Accent::hat));
  });
  if (other) return false;
  const auto written = [&](std::size_t from, std::size_t to) {
    return text_of(tokens.subspan(from, to - from));
  };
  const std::string function = written(application.begin, application.argument);
  const std::string letters = written(application.argument, cursor.at);
  const std::string bracket = written(open, end);
  return takes_second({cover(tokens[application.begin].span, tokens[end - 1].span),
                       fmt::format("{}({}) {}", function, letters, bracket),
                       fmt::format("{}({} {})", function, letters, bracket)});
}

/// `\ln(1 + x)^2`, `\ln\left(\frac{T}{T_0}\right)^{3/2}`: is the power one of the argument? Of a sine it
/// never is.
bool Parser::power_belongs(const Cursor& cursor, const Application& application) {
  static constexpr std::array<std::string_view, 4> logarithms{"ln", "log", "lg", "lb"};
  const TokenView tokens = cursor.tokens;
  const std::size_t script = skip_blank(tokens, cursor.at);
  if (!is_one_of(application.name, logarithms) || !is_kind_at(tokens, script, TokenKind::superscript))
    return false;
  const std::size_t end = script_argument_at(tokens, script + 1).next;
  const auto written = [&](std::size_t from, std::size_t to) {
    return text_of(tokens.subspan(from, to - from));
  };
  const std::string whole = written(application.begin, cursor.at);
  const std::string power = written(script, end);
  return takes_second(
      {cover(tokens[application.begin].span, tokens[end - 1].span), fmt::format("({}){}", whole, power),
       fmt::format("\\{}({}{})", application.name, written(application.argument, cursor.at), power)});
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
  const bool divided = is_control(token, "div") && !missing && !opens_argument(cursor.tokens[at]) &&
                       !is_bold(cursor.tokens, at) && !is_control(cursor.tokens[at], "qty");
  if (divided) return opaque(token.span, "`\\div` is read before a vector or a bracket only");
  cursor.at = at;
  if (missing || starts_sign(cursor) || factor_joint(cursor.token()) != Joint::none)
    return opaque(token.span, fmt::format("`\\{}` has nothing after it to act on", token.text));
  const SyntaxId argument = opens_argument(cursor.token()) ? bracket_argument(cursor) : factor(cursor);
  return tree_.add_named(SyntaxKind::function, cover(token.span, tree_[argument].span), std::string(name),
                         argument);
}

}  // namespace rigor
