// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers with units: \SI{3}{kg.m^2}, \qty{3}{\kilo\gram}, \unit{m/s}, \num{3.2e5}, \ang{30}, and
// 3\,\mathrm{kg}.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "base/among.h"
#include "base/ascii.h"
#include "latex/parse/parser.h"
#include "latex/token/cover_tokens.h"
#include "latex/token/differential.h"
#include "latex/unit/units.h"

namespace rigor {
namespace {

/// `\mathrm{dT}` is a differential in roman type, and no decitesla.
bool may_be_differential(TokenView content) {
  std::string letters;
  for (const Token& token : content) {
    if (token.kind == TokenKind::letter) letters += token.text;
  }
  return letters.size() == 2 && letters[0] == 'd';
}

constexpr int most_tens = 300;

/// `3.2e5` as digits, `320000`; nothing for what is no such number.
std::optional<std::string> digits_of(std::string_view text, bool& negative) {
  std::string digits;
  for (const char c : text) {
    if (c != ' ' && c != '~') digits += c == 'E' ? 'e' : c;
  }
  negative = digits.starts_with('-');
  if (negative || digits.starts_with('+')) digits.erase(0, 1);
  int tens = 0;
  if (const auto e = digits.find('e'); e != std::string::npos) {
    const std::size_t begin = e + (digits.substr(e + 1).starts_with('+') ? 2 : 1);
    const char* end = digits.data() + digits.size();
    const auto [last, error] = std::from_chars(digits.data() + begin, end, tens);
    if (error != std::errc() || last != end || tens > most_tens || tens < -most_tens) return std::nullopt;
    digits.erase(e);
  }
  auto point = digits.find('.');
  if (point == std::string::npos) point = digits.size();
  digits.erase(std::min(point, digits.size()), point < digits.size() ? 1 : 0);
  if (digits.empty() || !std::ranges::all_of(digits, is_digit)) return std::nullopt;
  auto at = static_cast<std::ptrdiff_t>(point) + tens;
  if (at <= 0) {
    digits.insert(0, static_cast<std::size_t>(1 - at), '0');
    at = 1;
  }
  const auto place = static_cast<std::size_t>(at);
  if (place >= digits.size()) return digits + std::string(place - digits.size(), '0');
  return digits.insert(place, ".");
}

/// The text of a unit, and where it ends.
struct QuantityUnit {
  std::string text;
  std::size_t next = 0;
};

std::string trimmed(std::string text) {
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

/// The 2 of `\text{m/s}^2` belongs to the second alone. `at`: behind the words.
QuantityUnit with_exponent(TokenView tokens, std::size_t at, QuantityUnit unit) {
  const bool compound = !std::ranges::all_of(unit.text, [](char c) { return is_letter(c) || c == ' '; });
  if (!compound || !is_kind_at(tokens, at, TokenKind::superscript)) return unit;
  const Argument exponent = argument_at(tokens, skip_blank(tokens, at + 1));
  const std::string whole = unit.text + "^{" + text_of(exponent.content) + "}";
  if (!read_unit(whole, UnitNames::units)) return unit;
  return {whole, exponent.next};
}

bool is_degree(std::string_view unit) { return is_one_of(unit, {"\\degree", "\\arcdegree", "°"}); }

bool is_upright(const Token& token) {
  const auto style = style_of(token);
  return (style && style->upright) || is_words(token);
}

/// `\mathrm{J}`, `\text{mol}\,\text{K}^2`, `1`: how many letters, all of them upright; nothing for other
/// signs.
std::optional<std::size_t> upright_letters(TokenView tokens) {
  std::size_t letters = 0;
  for (std::size_t at = 0; at < tokens.size();) {
    if (is_upright(tokens[at])) {
      const Argument argument = argument_at(tokens, at + 1);
      letters +=
          static_cast<std::size_t>(std::ranges::count(argument.content, TokenKind::letter, &Token::kind));
      at = argument.next;
    } else if (tokens[at].kind == TokenKind::letter) {
      return std::nullopt;
    } else {
      ++at;
    }
  }
  return letters;
}

}  // namespace

/// `\qty` with two braces, the second with a unit; with anything else it is a bracket of the physics
/// package.
bool Parser::starts_quantity(const Cursor& cursor) {
  const std::string_view name = cursor.token().text;
  if (name == "SI" || name == "si" || name == "num" || name == "ang") return true;
  if (name != "qty" && name != "unit") return false;
  const auto is_group = [&](std::size_t at) { return is_kind_at(cursor.tokens, at, TokenKind::begin_group); };
  const std::size_t options = skip_blank(cursor.tokens, cursor.at + 1);
  const std::size_t first = skip_blank(cursor.tokens, optional_argument_at(cursor.tokens, options).next);
  if (!is_group(first)) return false;
  if (name == "unit") return true;
  const Argument number = argument_at(cursor.tokens, first);
  const std::size_t second = skip_blank(cursor.tokens, number.next);
  bool negative = false;
  if (!is_group(second) || !digits_of(text_of(number.content), negative)) return false;
  const std::string unit = text_of(argument_at(cursor.tokens, second).content);
  return is_degree(unit) || read_unit(unit, UnitNames::units);
}

SyntaxId Parser::one_degree(Span span) {
  WrittenSymbol pi;
  pi.letter = "\\pi";
  pi.letter_span = span;
  const SyntaxChild parts[] = {{tree_.add_symbol(span, std::move(pi))},
                               {tree_.add_text(SyntaxKind::number, span, "180")}};
  return tree_.add(SyntaxKind::fraction, span, parts);
}

/// The place behind `^\circ`, `^{\circ}`, `\degree` or `°`; where the cursor is if none is there.
std::size_t Parser::degree_end(const Cursor& cursor) {
  if (cursor.done()) return cursor.at;
  const Token& token = cursor.token();
  if (is_control_of(token, {"degree", "textdegree"}) || token.text == "°") return cursor.at + 1;
  if (token.kind != TokenKind::superscript) return cursor.at;
  const Argument above = script_argument_at(cursor.tokens, cursor.at + 1);
  const TokenView sign = trim(above.content);
  const bool circle = sign.size() == 1 && is_control_of(sign[0], {"circ", "degree"});
  return circle ? above.next : cursor.at;
}

/// `30^\circ` is an angle; `25^\circ\mathrm C` is a temperature, and `60^\circ\mathrm N` a place.
SyntaxId Parser::in_degrees(Cursor& cursor, SyntaxId number, std::size_t end) {
  const Span span = cover(tree_[number].span, cursor.tokens.subspan(cursor.at, end - cursor.at));
  read(cursor.tokens.subspan(cursor.at, end - cursor.at));
  cursor.at = end;
  const std::size_t next = skip_narrow(cursor.tokens, end);
  if (next < cursor.tokens.size()) {
    const Token& token = cursor.tokens[next];
    const auto style = style_of(token);
    const bool upright = is_words(token) || (style && style->upright);
    const TokenView letter =
        upright ? trim(argument_at(cursor.tokens, next + 1).content) : cursor.tokens.subspan(next, 1);
    const bool one = letter.size() == 1 && letter[0].kind == TokenKind::letter;
    const std::string_view scales = upright ? "CFKRNESW" : "CFK";
    if (one && letter[0].text.size() == 1 && scales.find(letter[0].text) != std::string_view::npos)
      return opaque(span, "degrees of a temperature or of a place are not read");
  }
  const SyntaxChild factors[] = {{number}, {one_degree(span), Joint::juxtaposed, span}};
  const SyntaxChild whole{tree_.add(SyntaxKind::term, span, factors)};
  return tree_.add(SyntaxKind::group, span, {&whole, 1});
}

SyntaxId Parser::quantity(Cursor& cursor) {
  const Token token = cursor.token();
  const std::size_t begin = cursor.at;
  const bool is_angle = token.text == "ang";
  bool has_number = token.text == "SI" || token.text == "qty" || token.text == "num" || is_angle;
  const bool has_unit = token.text != "num" && !is_angle;
  std::size_t at = skip_blank(cursor.tokens, cursor.at + 1);
  const auto skip_options = [&] {
    if (!is_sign_at(cursor.tokens, at, "[")) return;
    while (at < cursor.tokens.size() && !is_sign(cursor.tokens[at], "]")) ++at;
    at = skip_blank(cursor.tokens, std::min(at + 1, cursor.tokens.size()));
  };
  skip_options();
  std::vector<SyntaxChild> factors;
  Span span = token.span;
  const auto argument = [&] {
    const Argument found = argument_at(cursor.tokens, at);
    at = found.next;
    span = cover(token.span, cursor.tokens.subspan(begin, at - begin));
    return text_of(found.content);
  };
  if (token.text == "SI" && trim(argument_at(cursor.tokens, at).content).empty()) {  // \SI{}{kg}
    static_cast<void>(argument());
    has_number = false;
  }
  if (has_number) {
    const std::string text = argument();
    bool negative = false;
    const auto digits = digits_of(text, negative);
    cursor.at = at;
    if (!digits) return opaque(span, fmt::format("`{}` is not read as a number", text));
    const SyntaxId number = tree_.add_text(SyntaxKind::number, span, *digits);
    const SyntaxChild minus{number, Joint::minus, span};
    factors.push_back({negative ? tree_.add(SyntaxKind::sum, span, {&minus, 1}) : number});
    if (is_angle) factors.push_back({one_degree(span), Joint::juxtaposed, span});
  }
  if (has_unit) {
    at = skip_blank(cursor.tokens, at);
    skip_options();
    const std::string text = argument();
    cursor.at = at;
    std::string problem;
    if (is_degree(text)) {
      factors.push_back({one_degree(span), Joint::juxtaposed, span});
    } else if (!read_unit(text, UnitNames::units, &problem)) {
      return opaque(span, std::move(problem));
    } else {
      factors.push_back({tree_.add_text(SyntaxKind::unit, span, text), Joint::juxtaposed, span});
    }
  }
  read_since(cursor, begin);
  if (factors.size() == 1 && tree_[factors[0].id].kind != SyntaxKind::sum) return factors[0].id;
  const SyntaxChild whole{factors.size() == 1 ? factors[0].id : tree_.add(SyntaxKind::term, span, factors)};
  return tree_.add(SyntaxKind::group, span, {&whole, 1});
}

/// A number, a power of one, a fraction of two, or what has a unit already. π is a number before units of
/// more than one letter.
bool Parser::takes_unit(SyntaxId id) const {
  switch (tree_[id].kind) {
    case SyntaxKind::symbol:
      return is_pi(id);
    case SyntaxKind::number:
    case SyntaxKind::unit:
      return true;
    case SyntaxKind::power:
      return takes_unit(tree_.child(id, 0));
    case SyntaxKind::fraction:
      return takes_unit(tree_.child(id, 0)) && takes_unit(tree_.child(id, 1));
    default:
      return false;
  }
}

bool Parser::is_pi(SyntaxId id) const {
  if (tree_[id].kind == SyntaxKind::power) return is_pi(tree_.child(id, 0));
  if (tree_[id].kind == SyntaxKind::fraction)
    return is_pi(tree_.child(id, 0)) && tree_[tree_.child(id, 1)].kind == SyntaxKind::number;
  return tree_[id].kind == SyntaxKind::symbol && tree_.symbol(id).letter == "\\pi" &&
         tree_.symbol(id).lower.empty() && tree_.symbol(id).primes == 0 &&
         tree_.symbol(id).accent == Accent::none;
}

bool Parser::has_unit(SyntaxId id) const {
  if (tree_[id].kind == SyntaxKind::power) return has_unit(tree_.child(id, 0));
  return tree_[id].kind == SyntaxKind::unit;
}

/// `6563\,\AA`
SyntaxId Parser::angstrom(Cursor& cursor) {
  const Span span = cursor.token().span;
  read(cursor.tokens.subspan(cursor.at, 1));
  ++cursor.at;
  return scripts(cursor, tree_.add_text(SyntaxKind::unit, span, "Å"));
}

/// `9.8\,\frac{\mathrm{m}}{\mathrm{s}^2}` behind its number. Like single letters,
/// `\frac{\mathrm{m}}{\mathrm{s}}` is a unit behind a space, or in words.
std::optional<SyntaxId> Parser::unit_fraction(Cursor& cursor, bool spaced) {
  const Argument above = argument_at(cursor.tokens, cursor.at + 1);
  const Argument below = argument_at(cursor.tokens, above.next);
  const TokenView whole = cursor.tokens.subspan(cursor.at, below.next - cursor.at);
  const auto over = upright_letters(above.content);
  const auto under = upright_letters(below.content);
  if (!over || !under || *under == 0) return std::nullopt;
  if (may_be_differential(above.content) && may_be_differential(below.content)) return std::nullopt;
  const bool apart = spaced || *over + *under > 2 || std::ranges::any_of(whole, is_words);
  const std::string text = text_of(above.content) + "/(" + text_of(below.content) + ")";
  if (!apart || !read_unit(text, UnitNames::units)) return std::nullopt;
  read(whole);
  cursor.at = below.next;
  return scripts(cursor, tree_.add_text(SyntaxKind::unit, span_of(whole), text));
}

/// A roman word after a number or a unit: `3\,\mathrm{kg\,m^2}`.
std::optional<SyntaxId> Parser::unit_behind(Cursor& cursor, SyntaxId before, bool spaced) {
  if (!takes_unit(before) || cursor.done()) return std::nullopt;
  if (cursor.token().kind == TokenKind::control && cursor.token().text == "AA") return angstrom(cursor);
  if (is_fraction(cursor.token())) return is_pi(before) ? std::nullopt : unit_fraction(cursor, spaced);
  if (!is_upright(cursor.token())) return std::nullopt;
  const Argument word = argument_at(cursor.tokens, cursor.at + 1);
  const std::string text = text_of(word.content);
  const bool apart = (spaced || is_words(cursor.token()) || has_unit(before)) && !is_pi(before);
  const std::size_t behind = skip_blank(cursor.tokens, word.next);
  const bool goes_on = behind < cursor.tokens.size() && (cursor.tokens[behind].kind == TokenKind::subscript ||
                                                         is_sign_of(cursor.tokens[behind], "('"));
  if (goes_on || !is_unit_word(text, apart)) return std::nullopt;
  const QuantityUnit unit = with_exponent(cursor.tokens, behind, {trimmed(text), word.next});
  const Span span =
      cover(cursor.token().span, span_of(cursor.tokens.subspan(cursor.at, unit.next - cursor.at)));
  read(cursor.tokens.subspan(cursor.at, unit.next - cursor.at));
  cursor.at = unit.next;
  return scripts(cursor, tree_.add_text(SyntaxKind::unit, span, unit.text));
}

}  // namespace rigor
