// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/reading/rearrangements.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "base/among.h"
#include "base/ascii.h"
#include "latex/reading/placed_letters.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

bool is_function_name(const Token& token) {
  return is_control_of(token, {"sin", "cos", "tan", "cot", "sinh", "cosh", "tanh", "coth"});
}

/// A factor with its scripts, as products of operators have them: `\hat A`, `a^\dagger`, `[A, B]`.
struct OrderedFactor {
  TokenView tokens;
  bool may_act = false;  // its order may count
};

class Rearranger {
 public:
  Rearranger(TokenView side, const std::vector<TokenView>& chain) : side_(side), chain_(chain) {}

  std::vector<Rewriting> all() {
    for (const PieceLevel& level : levels_of(side_)) {
      if (!level.may_be_sum) continue;
      for (const PieceTerm& term : terms_of(level)) factors_of_term(term.tokens);
    }
    for (std::size_t k = 0; k < side_.size(); ++k) {
      matrix(k);
      argument(k);
      exponent(k);
      root(k);
      held(k);
    }
    return std::move(rewritings_);
  }

 private:
  std::size_t place(TokenView part) const { return static_cast<std::size_t>(part.data() - side_.data()); }
  TokenView between(std::size_t begin, std::size_t end) const { return side_.subspan(begin, end - begin); }
  Token made(TokenKind kind, std::string_view text, std::size_t at) const {
    const Span beside = side_[std::min(at, side_.size() - 1)].span;
    return {kind, text, {beside.file, beside.begin, beside.begin}};
  }

  void add(Slip slip, std::size_t begin, std::size_t end, Tokens to, TokenView shown) {
    Rewriting change{.slip = slip, .begin = begin, .end = end, .text = std::move(to)};
    change.shown_begin = std::min(place(shown), begin);
    change.shown_end = std::max(place(shown) + shown.size(), end);
    rewritings_.push_back(std::move(change));
  }

  // --- the order of factors

  /// The place behind the factor that begins there, without scripts.
  static std::size_t behind_factor(TokenView term, std::size_t at) {
    if (is_sign_of(term[at], "([")) {
      Nesting nesting(false);
      std::size_t end = at;
      while (end < term.size() && (nesting.enter(term[end]) != 0 || end == at)) ++end;
      return std::min(end + 1, term.size());
    }
    if (style_of(term[at]) || dots_of(term[at]) > 0) return argument_at(term, at + 1).next;
    std::size_t end = at + 1;
    if (term[at].kind == TokenKind::control) {
      while (is_kind_at(term, end, TokenKind::begin_group)) end = argument_at(term, end).next;
    }
    return end;
  }

  static bool may_act(TokenView factor) {
    const bool capital = factor[0].kind == TokenKind::letter && is_capital_letter(factor[0].text);
    const bool shown = is_control_of(factor[0], {"hat", "comm", "sigma", "mathbf", "mathsf"});
    const bool adjoint = std::ranges::any_of(factor, [](const Token& token) {
      return is_control_of(token, {"dagger", "dag"});
    });
    return capital || shown || adjoint || is_sign(factor[0], "[") || factor[0].text == "a";
  }

  static std::vector<OrderedFactor> ordered_factors(TokenView term) {
    std::vector<OrderedFactor> factors;
    for (std::size_t at = 0; at < term.size();) {
      if (is_blank(term[at]) || is_spacing(term[at]) || is_bracket_size(term[at])) {
        ++at;
        continue;
      }
      const std::size_t begin = at;
      at = behind_factor(term, at);
      while (at < term.size() && is_script(term[at]))
        at = is_sign(term[at], "'") ? at + 1 : script_argument_at(term, at + 1).next;
      const TokenView tokens = term.subspan(begin, at - begin);
      factors.push_back({tokens, may_act(tokens)});
    }
    return factors;
  }

  /// `[A, C]B` for `B[A, C]`
  void factors_of_term(TokenView term) {
    const std::vector<OrderedFactor> factors = ordered_factors(term);
    for (std::size_t k = 1; k < factors.size(); ++k) {
      const OrderedFactor& one = factors[k - 1];
      const OrderedFactor& other = factors[k];
      if (!one.may_act || !other.may_act || text_of(one.tokens) == text_of(other.tokens)) continue;
      const TokenView whole(one.tokens.data(), other.tokens.data() + other.tokens.size());
      Tokens to(other.tokens.begin(), other.tokens.end());
      const TokenView gap(one.tokens.data() + one.tokens.size(), other.tokens.data());
      to.insert(to.end(), gap.begin(), gap.end());
      to.insert(to.end(), one.tokens.begin(), one.tokens.end());
      add(Slip::order, place(whole), place(whole) + whole.size(), std::move(to), whole);
    }
  }

  // --- rows and columns

  using Cells = std::vector<std::vector<TokenView>>;

  /// What is in `\begin{pmatrix}…\end{pmatrix}`, if there are as many rows as columns.
  static std::optional<Cells> square_cells(TokenView inside) {
    Cells rows(1);
    std::size_t begin = 0;
    Nesting nesting(false);
    for (std::size_t k = 0; k <= inside.size(); ++k) {
      const bool end = k == inside.size();
      const bool outside = end || nesting.enter(inside[k]) == 0;
      const bool row = !end && outside && is_control(inside[k], "\\");
      const bool cell = !end && outside && inside[k].kind == TokenKind::align;
      if (!end && !row && !cell) continue;
      const TokenView content = trim(inside.subspan(begin, k - begin));
      begin = k + 1;
      if (end && content.empty() && rows.back().empty()) break;
      rows.back().push_back(content);
      if (row) rows.emplace_back();
    }
    if (rows.back().empty()) rows.pop_back();
    const bool square = rows.size() > 1 &&
                        std::ranges::all_of(rows, [&](const auto& row) { return row.size() == rows.size(); });
    return square ? std::optional(std::move(rows)) : std::nullopt;
  }

  void matrix(std::size_t k) {
    if (!is_control(side_[k], "begin")) return;
    const Argument name = argument_at(side_, k + 1);
    if (!text_of(name.content).ends_with("matrix")) return;
    const auto end = std::ranges::find_if(side_.subspan(name.next),
                                          [](const Token& token) { return is_control(token, "end"); });
    if (end == side_.end()) return;
    const auto stop = static_cast<std::size_t>(&*end - side_.data());
    const auto cells = square_cells(between(name.next, stop));
    if (!cells) return;
    Tokens to;
    for (std::size_t row = 0; row < cells->size(); ++row) {
      for (std::size_t column = 0; column < cells->size(); ++column) {
        if (column > 0) to.push_back(made(TokenKind::align, "&", k));
        const TokenView cell = (*cells)[column][row];
        to.insert(to.end(), cell.begin(), cell.end());
      }
      if (row + 1 < cells->size()) to.push_back(made(TokenKind::control, "\\", k));
    }
    add(Slip::order, name.next, stop, std::move(to), between(k, argument_at(side_, stop + 1).next));
  }

  // --- arguments, exponents, roots

  /// The letters and numbers behind a function that has no bracket.
  std::size_t behind_argument(std::size_t at) const {
    while (at < side_.size()) {
      const bool number = side_[at].kind == TokenKind::digit;
      const bool letter = !letters_in(side_.subspan(at, 1)).empty();
      if (number || letter || is_spacing(side_[at])) {
        ++at;
      } else if (side_[at].kind == TokenKind::subscript || is_sign(side_[at], "'")) {
        at = is_sign(side_[at], "'") ? at + 1 : script_argument_at(side_, at + 1).next;
      } else {
        break;
      }
    }
    return at;
  }

  void argument(std::size_t k) {
    if (!is_function_name(side_[k])) return;
    std::size_t begin = k + 1;
    if (is_kind_at(side_, begin, TokenKind::superscript)) begin = script_argument_at(side_, begin + 1).next;
    begin = skip_blank(side_, begin);
    if (begin >= side_.size()) return;
    if (is_fraction(side_[begin])) {
      const Argument upper = argument_at(side_, begin + 1);
      const Argument lower = argument_at(side_, upper.next);
      if (text_of(lower.content) != "2") return;
      Tokens whole{made(TokenKind::space, " ", begin)};
      whole.insert(whole.end(), upper.content.begin(), upper.content.end());
      return add(Slip::factor, begin, lower.next, std::move(whole), between(k, lower.next));
    }
    const std::size_t end = behind_argument(begin);
    if (end == begin) return;
    const TokenView shown = between(k, end);
    if (side_[begin].kind == TokenKind::digit) {
      if (side_[begin].text == "2" && !is_kind_at(side_, begin + 1, TokenKind::digit) && end > begin + 1)
        add(Slip::factor, begin, begin + 1, {made(TokenKind::space, " ", begin)}, shown);
      return;
    }
    add(Slip::factor, begin, begin, {made(TokenKind::digit, "2", begin)}, shown);
    Tokens half{made(TokenKind::control, "frac", begin), made(TokenKind::begin_group, "{", begin)};
    half.insert(half.end(), side_.begin() + static_cast<std::ptrdiff_t>(begin),
                side_.begin() + static_cast<std::ptrdiff_t>(end));
    half.push_back(made(TokenKind::end_group, "}", begin));
    half.push_back(made(TokenKind::begin_group, "{", begin));
    half.push_back(made(TokenKind::digit, "2", begin));
    half.push_back(made(TokenKind::end_group, "}", begin));
    add(Slip::factor, begin, end, std::move(half), shown);
  }

  bool is_base_of_exponentials(std::size_t at) const {
    return at > 0 && (side_[at - 1].text == "e" || side_[at - 1].kind == TokenKind::end_group);
  }

  /// `q^{n+1}` for `q^n`, `h^{1/3}` for `h^{1/2}`
  void exponent(std::size_t k) {
    static constexpr std::array<std::string_view, 4> usual{"1/2", "1/3", "2/3", "3/2"};
    if (side_[k].kind != TokenKind::superscript || k + 1 >= side_.size()) return;
    const Argument argument = argument_at(side_, k + 1);
    if (argument.content.empty()) return;
    const TokenView whole = between(k, argument.next);
    const std::string text = text_of(argument.content);
    if (is_one_of(text, usual)) {
      for (const std::string_view other : usual) {
        if (other == text) continue;
        Tokens to{made(TokenKind::superscript, "^", k), made(TokenKind::begin_group, "{", k)};
        to.push_back(made(TokenKind::digit, other.substr(0, 1), k));
        to.push_back(made(TokenKind::other, "/", k));
        to.push_back(made(TokenKind::digit, other.substr(2), k));
        to.push_back(made(TokenKind::end_group, "}", k));
        add(Slip::power, k, argument.next, std::move(to), whole);
      }
      return;
    }
    const bool letters = std::ranges::all_of(argument.content, [](const Token& token) {
      return token.kind == TokenKind::letter || is_greek(letter_of(token)) || token.kind == TokenKind::digit;
    });
    const bool number = argument.content[0].kind == TokenKind::digit && argument.content.size() == 1;
    const bool turned = argument.content.size() == 1 && is_one_of(text, {"T", "H", "t"});
    if (!letters || number || turned || is_base_of_exponentials(k)) return;
    for (const std::string_view sign : {"+", "-"}) {
      Tokens to{made(TokenKind::superscript, "^", k), made(TokenKind::begin_group, "{", k)};
      to.insert(to.end(), argument.content.begin(), argument.content.end());
      to.push_back(made(TokenKind::other, sign, k));
      to.push_back(made(TokenKind::digit, "1", k));
      to.push_back(made(TokenKind::end_group, "}", k));
      add(Slip::power, k, argument.next, std::move(to), whole);
    }
  }

  /// What is under a root, without it.
  void root(std::size_t k) {
    if (!is_control(side_[k], "sqrt") || !is_kind_at(side_, k + 1, TokenKind::begin_group)) return;
    const Argument under = argument_at(side_, k + 1);
    Tokens to{made(TokenKind::other, "(", k)};
    to.insert(to.end(), under.content.begin(), under.content.end());
    to.push_back(made(TokenKind::other, ")", k));
    add(Slip::power, k, under.next, std::move(to), between(k, under.next));
  }

  /// `(\partial V/\partial S)_p` for `(\partial V/\partial S)_T`, of the letters of the chain.
  void held(std::size_t k) {
    if (side_[k].kind != TokenKind::subscript || k == 0 || !is_sign(side_[k - 1], ")")) return;
    const Argument letter = argument_at(side_, k + 1);
    if (letter.content.size() != 1 || letter.content[0].kind != TokenKind::letter) return;
    std::set<std::string_view> others;
    for (const TokenView side : chain_) {
      for (const PlacedLetter& each : letters_in(side)) {
        const Token& other = side[each.at];
        if (other.kind == TokenKind::letter && other.text != letter.content[0].text)
          others.insert(other.text);
      }
    }
    const std::size_t at = place(letter.content);
    for (const std::string_view other : others)
      add(Slip::index, at, at + 1, {made(TokenKind::letter, other, at)}, between(k, letter.next));
  }

  TokenView side_;
  const std::vector<TokenView>& chain_;
  std::vector<Rewriting> rewritings_;
};

}  // namespace

std::vector<Rewriting> rearrangements_of(TokenView side, const std::vector<TokenView>& chain) {
  return side.empty() ? std::vector<Rewriting>{} : Rearranger(side, chain).all();
}

}  // namespace rigor
