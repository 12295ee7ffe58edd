// SPDX-License-Identifier: GPL-3.0-or-later
// Terms with other coefficients and other letters.
#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "latex/reading/placed_letters.h"
#include "latex/reading/rewritings.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

constexpr std::string_view all_digits = "0123456789";

Token sign(std::string_view text, Span at) { return {TokenKind::other, text, at}; }

void add_number(Tokens& into, long value, Span at) {
  for (const char digit : std::to_string(value))
    into.push_back({TokenKind::digit, all_digits.substr(static_cast<std::size_t>(digit - '0'), 1), at});
}

void add_group(Tokens& into, long value, Span at) {
  into.push_back({TokenKind::begin_group, "{", at});
  add_number(into, value, at);
  into.push_back({TokenKind::end_group, "}", at});
}

bool is_fraction_control(const Token& token) { return is_control_of(token, {"frac", "tfrac", "dfrac"}); }

std::optional<long> number_in(TokenView tokens) {
  const TokenView digits = trim(tokens);
  if (digits.empty() || digits.size() > 4) return std::nullopt;
  long value = 0;
  for (const Token& token : digits) {
    if (token.kind != TokenKind::digit) return std::nullopt;
    value = 10 * value + (token.text[0] - '0');
  }
  return value;
}

/// The number that a term begins with, and how many tokens it takes, a dot or blanks after it included.
struct Leading {
  Coefficient value;
  std::size_t tokens = 0;
};

Leading leading_of(TokenView term) {
  Leading leading;
  if (term.empty()) return leading;
  if (is_fraction_control(term[0])) {
    const Argument upper = argument_at(term, 1);
    const Argument lower = argument_at(term, upper.next);
    const auto numerator = number_in(upper.content);
    const auto denominator = number_in(lower.content);
    if (!numerator || !denominator || *denominator == 0 || *numerator == 0) return leading;
    leading = {{*numerator, *denominator}, lower.next};
  } else {
    std::size_t digits = 0;
    while (is_kind_at(term, digits, TokenKind::digit)) ++digits;
    const auto number = number_in(term.first(digits));
    if (!number || *number == 0) return leading;
    if (digits < term.size() && is_sign_of(term[digits], ".!")) return leading;
    leading = {{*number, 1}, digits};
  }
  if (leading.tokens < term.size() && term[leading.tokens].kind == TokenKind::superscript) return {};
  std::size_t behind = skip_blank(term, leading.tokens);
  if (behind < term.size() && (is_control(term[behind], "cdot") || is_control(term[behind], ",")))
    behind = skip_blank(term, behind + 1);
  const bool divides = is_sign_at(term, behind, "/");
  leading.tokens = divides ? leading.tokens : behind;
  return leading;
}

Coefficient product(Coefficient a, Coefficient b) {
  Coefficient result{a.numerator * b.numerator, a.denominator * b.denominator};
  const long common = std::gcd(result.numerator, result.denominator);
  if (common > 1) result = {result.numerator / common, result.denominator / common};
  return result;
}

/// The term with another number before it; no number for 1, unless nothing else is left.
Tokens with_leading(TokenView term, Coefficient value, std::size_t leading) {
  const Span at{span_of(term).file, span_of(term).begin, span_of(term).begin};
  const TokenView rest = trim(term.subspan(leading));
  const long size = std::abs(value.numerator);
  Tokens result;
  const bool division = !rest.empty() && is_sign(rest[0], "/");
  if (value.denominator != 1) {
    result.push_back({TokenKind::control, "frac", at});
    add_group(result, size, at);
    add_group(result, value.denominator, at);
  } else if (size != 1 || rest.empty() || division) {
    add_number(result, size, at);
  }
  const bool before_unit = leading > 0 && is_control(term[leading - 1], ",");
  if (before_unit && !result.empty()) result.push_back({TokenKind::control, ",", at});
  const bool runs_together = !result.empty() && !rest.empty() && rest[0].kind == TokenKind::digit;
  if (runs_together) result.push_back({TokenKind::control, "cdot", at});
  result.insert(result.end(), rest.begin(), rest.end());
  return result;
}

std::size_t place_in(TokenView side, TokenView part) {
  return static_cast<std::size_t>(part.data() - side.data());
}

// --- images

bool is_index_token(const Token& token) {
  return token.kind == TokenKind::letter || token.kind == TokenKind::digit;
}

/// Which tokens of a term are letters of its own, which are on subscripts.
enum class Role : std::uint8_t { none, letter, index };

std::vector<Role> roles_of(TokenView term) {
  static const WordSet greek("alpha beta gamma theta phi psi omega Omega lambda tau sigma rho");
  std::vector<Role> roles(term.size(), Role::none);
  const auto is_name = [&](std::size_t k) {
    return k < term.size() && (term[k].kind == TokenKind::letter ||
                               (term[k].kind == TokenKind::control && greek.contains(term[k].text)));
  };
  for (std::size_t k = 0; k < term.size(); ++k) {
    const bool of_differential =
        term[k].text == "d" && term[k].kind == TokenKind::letter && is_name(k + 1);  // `d\omega`
    if (is_name(k) && !of_differential) roles[k] = Role::letter;
  }
  for (std::size_t k = 0; k < term.size(); ++k) {
    if (is_control(term[k], "text") || is_control(term[k], "mathrm")) {
      const Argument words = argument_at(term, k + 1);
      std::fill(roles.begin() + static_cast<std::ptrdiff_t>(k),
                roles.begin() + static_cast<std::ptrdiff_t>(words.next), Role::none);
    }
    if (term[k].kind != TokenKind::subscript && term[k].kind != TokenKind::superscript) continue;
    const Argument script = argument_at(term, k + 1);
    const bool lower = term[k].kind == TokenKind::subscript;
    const bool word =
        std::ranges::any_of(script.content, [](const Token& token) { return is_control(token, "text"); });
    for (std::size_t i = k + 1; i < script.next; ++i)
      roles[i] = lower && !word && is_index_token(term[i]) ? Role::index : Role::none;
  }
  return roles;
}

bool is_same(const Token& a, const Token& b) { return a.kind == b.kind && a.text == b.text; }

using Exchange = std::vector<std::pair<Token, Token>>;

void add_exchanges(std::vector<Exchange>& exchanges, const std::vector<Token>& names) {
  for (std::size_t a = 0; a < names.size(); ++a) {
    for (std::size_t b = a + 1; b < names.size(); ++b)
      exchanges.push_back({{names[a], names[b]}, {names[b], names[a]}});
  }
  if (names.size() == 3) {
    exchanges.push_back({{names[0], names[1]}, {names[1], names[2]}, {names[2], names[0]}});
    exchanges.push_back({{names[0], names[2]}, {names[2], names[1]}, {names[1], names[0]}});
  }
}

/// 1 → 2 → 3 → 1 and x → y → z → x, once and twice.
void add_turns(std::vector<Exchange>& exchanges, TokenKind kind,
               const std::array<std::string_view, 3>& cycle) {
  const auto name = [&](std::size_t k) { return Token{kind, cycle[k % 3], {}}; };
  for (const std::size_t step : {1u, 2u}) {
    Exchange turn;
    for (std::size_t k = 0; k < 3; ++k) turn.emplace_back(name(k), name(k + step));
    exchanges.push_back(std::move(turn));
  }
}

/// Up to five names that are in this role, but for digits.
std::vector<Token> names_in(TokenView tokens, Role role) {
  const std::vector<Role> roles = roles_of(tokens);
  std::vector<Token> names;
  for (std::size_t k = 0; k < tokens.size() && names.size() < 5; ++k) {
    if (roles[k] != role || tokens[k].kind == TokenKind::digit) continue;
    const bool known =
        std::ranges::any_of(names, [&](const Token& name) { return is_same(name, tokens[k]); });
    if (!known) names.push_back(tokens[k]);
  }
  return names;
}

void add_replacements(std::vector<Exchange>& exchanges, const std::vector<Token>& names,
                      const std::vector<Token>& others) {
  for (const Token& name : names) {
    for (const Token& other : others) {
      const bool own = std::ranges::any_of(names, [&](const Token& each) { return is_same(each, other); });
      if (!own) exchanges.push_back({{name, other}});
    }
  }
}

Tokens exchanged(TokenView term, const std::vector<Role>& roles, Role role, const Exchange& exchange) {
  Tokens result(term.begin(), term.end());
  for (std::size_t k = 0; k < result.size(); ++k) {
    if (roles[k] != role) continue;
    for (const auto& [from, to] : exchange) {
      if (!is_same(term[k], from)) continue;
      result[k].kind = to.kind;
      result[k].text = to.text;
      break;
    }
  }
  return result;
}

bool is_inside(TokenView part, const Token& token) {
  return &token >= part.data() && &token < part.data() + part.size();
}

/// `\cos a\sin b` for `\sin a\cos b`: each function for its neighbour alone, and all at once.
std::vector<Tokens> with_other_functions(TokenView term) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 4> neighbours{
      {{"sin", "cos"}, {"cos", "sin"}, {"sinh", "cosh"}, {"cosh", "sinh"}}};
  const auto neighbour = [](const Token& token) {
    return token.kind == TokenKind::control
               ? std::ranges::find(neighbours, token.text,
                                   &std::pair<std::string_view, std::string_view>::first)
               : neighbours.end();
  };
  std::vector<Tokens> images;
  Tokens all(term.begin(), term.end());
  for (std::size_t k = 0; k < term.size(); ++k) {
    const auto other = neighbour(term[k]);
    if (other == neighbours.end()) continue;
    Tokens one(term.begin(), term.end());
    one[k].text = all[k].text = other->second;
    images.push_back(std::move(one));
  }
  if (images.size() > 1) images.push_back(std::move(all));
  return images;
}

/// `a\dot b` for `\dot ab`.
std::vector<Tokens> with_moved_dot(TokenView term) {
  std::vector<Tokens> images;
  for (std::size_t k = 0; k < term.size(); ++k) {
    if (dots_of(term[k]) == 0) continue;
    const Argument under = argument_at(term, k + 1);
    for (const PlacedLetter& letter : letters_in(term)) {
      if (letter.begin >= k && letter.end <= under.next) continue;
      Tokens image;
      for (std::size_t i = 0; i < term.size(); ++i) {
        if (i == letter.begin) {
          image.push_back(term[k]);
          image.push_back({TokenKind::begin_group, "{", term[k].span});
        }
        const bool of_dot = i == k || (i > k && i < under.next && !is_inside(under.content, term[i]));
        if (!of_dot) image.push_back(term[i]);
        if (i + 1 == letter.end) image.push_back({TokenKind::end_group, "}", term[k].span});
      }
      images.push_back(std::move(image));
    }
  }
  return images;
}

}  // namespace

Tokens without_layout(TokenView tokens) {
  Tokens result;
  int tables = 0;  // in which `&` and `\\` stand between entries
  for (const Token& token : trim(tokens)) {
    tables += is_control(token, "begin") ? 1 : is_control(token, "end") ? -1 : 0;
    const bool between = token.kind == TokenKind::align || is_control(token, "\\");
    const bool layout = (between && tables == 0) || token.kind == TokenKind::paragraph ||
                        is_control_of(token, {"nonumber", "notag"});
    if (!layout) result.push_back(token);
  }
  return result;
}

std::vector<SideTerm> terms_of_side(TokenView side) {
  const std::vector<PieceLevel> levels = levels_of(side);
  std::vector<SideTerm> terms;
  for (const PieceTerm& term : terms_of(levels.front())) {
    const Token* begin = term.sign == nullptr ? term.tokens.data() : term.sign->tokens.data();
    terms.push_back({term.tokens, {begin, term.tokens.data() + term.tokens.size()}});
  }
  if (terms.size() == 1 && text_of(terms[0].tokens) == "0") terms.clear();
  return terms;
}

Rewriting with_coefficient(TokenView side, std::size_t which, Coefficient times) {
  const std::vector<PieceLevel> levels = levels_of(side);
  const std::vector<PieceTerm> terms = terms_of(levels.front());
  const PieceTerm& term = terms[which];
  Rewriting change;
  change.begin = term.sign == nullptr ? place_in(side, term.tokens) : place_in(side, term.sign->tokens);
  change.end = place_in(side, term.tokens) + term.tokens.size();
  change.shown_begin = change.begin;
  change.shown_end = change.end;
  const Span at{span_of(term.tokens).file, span_of(term.tokens).begin, span_of(term.tokens).begin};
  if (times.numerator == 0) {
    change.slip = Slip::term_extra;
    if (terms.size() == 1) add_number(change.text, 0, at);
    const bool next_is_first = which == 0 && terms.size() > 1 && terms[1].sign->kind == PieceKind::plus;
    if (next_is_first) change.end = place_in(side, terms[1].sign->tokens) + 1;
    return change;
  }
  const Leading leading = leading_of(term.tokens);
  const Coefficient value = product(leading.value, times);
  const bool was_negative = term.sign != nullptr && term.sign->kind == PieceKind::minus;
  const bool negative = was_negative != (times.numerator < 0);
  const bool sign_only = std::abs(times.numerator) == 1 && times.denominator == 1;
  change.slip = sign_only ? Slip::sign : Slip::factor;
  if (negative) change.text.push_back(sign("-", at));
  if (!negative && which > 0) change.text.push_back(sign("+", at));
  const Tokens body = sign_only ? Tokens(term.tokens.begin(), term.tokens.end())
                                : with_leading(term.tokens, value, leading.tokens);
  if (!change.text.empty() && which > 0) change.text.push_back({TokenKind::space, " ", at});
  change.text.insert(change.text.end(), body.begin(), body.end());
  return change;
}

Rewriting with_term(TokenView side, TokenView term, Coefficient times) {
  const bool alone = terms_of_side(side).empty();
  const TokenView body = trim(side);
  const Span at{span_of(body).file, span_of(body).end, span_of(body).end};
  const Leading leading = leading_of(term);
  const Coefficient value = product(leading.value, times);
  Rewriting change{.slip = Slip::term_missing};
  change.end = place_in(side, body) + body.size();
  change.begin = alone ? place_in(side, body) : change.end;
  change.shown_begin = change.begin;
  change.shown_end = change.end;
  const Token space{TokenKind::space, " ", at};
  if (value.numerator < 0 || !alone) {
    if (!alone) change.text.push_back(space);
    change.text.push_back(sign(value.numerator < 0 ? "-" : "+", at));
    if (!alone) change.text.push_back(space);
  }
  const Tokens with_number = with_leading(term, value, leading.tokens);
  change.text.insert(change.text.end(), with_number.begin(), with_number.end());
  return change;
}

std::vector<Tokens> images_of_term(TokenView term, const std::vector<TokenView>& chain) {
  const std::vector<Role> roles = roles_of(term);
  const std::vector<Token> letters = names_in(term, Role::letter);
  const std::vector<Token> indices = names_in(term, Role::index);
  std::vector<Tokens> images;
  std::set<std::string> known{text_of(term)};
  const auto add = [&](Role role, const std::vector<Exchange>& exchanges) {
    for (const Exchange& exchange : exchanges) {
      Tokens image = exchanged(term, roles, role, exchange);
      if (known.insert(text_of(image)).second) images.push_back(std::move(image));
    }
  };
  std::vector<Exchange> of_letters;
  std::vector<Exchange> of_indices;
  add_exchanges(of_letters, letters);
  add_exchanges(of_indices, indices);
  for (const TokenView side : chain) {
    add_replacements(of_letters, letters, names_in(side, Role::letter));
    add_replacements(of_indices, indices, names_in(side, Role::index));
  }
  add_turns(of_letters, TokenKind::letter, {"x", "y", "z"});
  add_turns(of_indices, TokenKind::letter, {"x", "y", "z"});
  add_turns(of_indices, TokenKind::digit, {"1", "2", "3"});
  add(Role::letter, of_letters);
  add(Role::index, of_indices);
  for (Tokens& image : with_other_functions(term)) {
    if (known.insert(text_of(image)).second) images.push_back(std::move(image));
  }
  for (Tokens& image : with_moved_dot(term)) {
    if (known.insert(text_of(image)).second) images.push_back(std::move(image));
  }
  return images;
}

}  // namespace rigor
