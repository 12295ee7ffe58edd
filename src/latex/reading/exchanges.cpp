// SPDX-License-Identifier: GPL-3.0-or-later
// Slips that are no matter of one sign or index: two things exchanged, a face, a function, a factor at the
// wrong place.
#include "latex/reading/exchanges.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "base/among.h"
#include "latex/reading/placed_letters.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

constexpr std::size_t most_exchanges = 60;  // of indices in one term
constexpr std::size_t most_letters_near = 16;

bool differentiates(TokenView tokens) {
  return std::ranges::any_of(tokens, [](const Token& token) {
    return is_control_of(token, {"partial", "nabla", "mathrm"}) ||
           (token.kind == TokenKind::letter && token.text == "d");
  });
}

class Exchanger {
 public:
  Exchanger(TokenView side, const std::vector<TokenView>& chain) : side_(side), chain_(chain) {}

  std::vector<Rewriting> all() {
    collect_factors();
    collect_components();
    for (const PieceLevel& level : levels_with_exponents(side_)) {
      if (!level.may_be_sum) continue;
      const std::vector<PieceTerm> terms = terms_of(level);
      for (std::size_t k = 0; k < terms.size(); ++k) {
        indices_between(terms[k].tokens);
        letters_within(terms[k].tokens);
        missing_factors(terms[k].tokens);
        if (k > 0) exchange(Slip::terms_exchanged, terms[k - 1].tokens, terms[k].tokens);
      }
      for (const Piece& piece : level.pieces) {
        if (piece.kind == PieceKind::big_sum)
          missing_factors_at(place(piece.tokens) + piece.tokens.size(), piece.tokens);
      }
      quotients(level);
      extra_factors(level);
    }
    for (std::size_t k = 0; k < side_.size(); ++k) {
      function(k);
      fraction(k);
      rate(k);
      digit_too_many(k);
    }
    letters();
    return std::move(rewritings_);
  }

  /// Letters that no side of the chain has.
  std::vector<Rewriting> with_letters_of(const std::vector<TokenView>& near) {
    const std::vector<FacedLetter> own = letters_of_sides(chain_);
    std::vector<FacedLetter> others = letters_of_sides(near);
    std::erase_if(others, [&](const FacedLetter& each) { return std::ranges::count(own, each) > 0; });
    if (others.size() > most_letters_near) others.resize(most_letters_near);
    for (const PlacedLetter& letter : letters_in(side_)) replace(letter, others);
    for (const FacedLetter& each : others) {
      if (each.face.empty()) factors_.push_back(each.token);
    }
    for (const PieceLevel& level : levels_with_exponents(side_)) {
      if (!level.may_be_sum) continue;
      for (const PieceTerm& term : terms_of(level)) missing_factors(term.tokens);
    }
    return std::move(rewritings_);
  }

 private:
  struct FacedLetter {
    TokenView token;
    std::string_view face;
    friend bool operator==(const FacedLetter& a, const FacedLetter& b) {
      return a.token[0].text == b.token[0].text && a.face == b.face;
    }
  };

  /// Each once, in their order.
  static std::vector<FacedLetter> letters_of_sides(const std::vector<TokenView>& sides) {
    std::vector<FacedLetter> letters;
    for (const TokenView side : sides) {
      for (const PlacedLetter& letter : letters_in(side)) {
        const FacedLetter each{side.subspan(letter.at, 1), letter.face};
        if (std::ranges::count(letters, each) == 0) letters.push_back(each);
      }
    }
    return letters;
  }

  /// The d of `dx` is no letter to put in.
  void replace(const PlacedLetter& letter, const std::vector<FacedLetter>& others) {
    const TokenView whole = side_.subspan(letter.begin, letter.end - letter.begin);
    for (const FacedLetter& other : others) {
      const bool of_differential = other.token[0].text == "d" && differentiates_;
      if (!of_differential && other.face == letter.face && other.token[0].text != side_[letter.at].text)
        add(Slip::letter, letter.at, letter.at + 1, {other.token[0]}, whole);
    }
  }

  std::size_t place(TokenView part) const { return static_cast<std::size_t>(part.data() - side_.data()); }
  Token made(TokenKind kind, std::string_view text, std::size_t at) const {
    const Span beside = side_[std::min(at, side_.size() - 1)].span;
    return {kind, text, {beside.file, beside.begin, beside.begin}};
  }

  void add(Slip slip, std::size_t begin, std::size_t end, Tokens to, TokenView shown) {
    std::string key;
    for (const Token& token : to) key += std::string(token.text) + " ";
    if (!known_.insert({begin, end, std::move(key)}).second) return;
    Rewriting change{.slip = slip, .begin = begin, .end = end, .text = std::move(to)};
    change.shown_begin = std::min(place(shown), begin);
    change.shown_end = std::max(place(shown) + shown.size(), end);
    rewritings_.push_back(std::move(change));
  }

  void exchange(Slip slip, TokenView first, TokenView second) {
    if (first.data() + first.size() > second.data() || text_of(first) == text_of(second)) return;
    const TokenView between(first.data() + first.size(), second.data());
    const std::size_t at = place(first);
    const std::size_t begin = at > 0 && takes_one_token(side_[at - 1]) ? at - 1 : at;  // `_1b_2`, `\hat xp`
    Tokens to(side_.begin() + static_cast<std::ptrdiff_t>(begin),
              side_.begin() + static_cast<std::ptrdiff_t>(at));
    to.insert(to.end(), second.begin(), second.end());
    to.insert(to.end(), between.begin(), between.end());
    to.insert(to.end(), first.begin(), first.end());
    const TokenView all(first.data(), second.data() + second.size());
    add(slip, begin, at + all.size(), std::move(to), all);
  }

  /// `\delta_{jl}\delta_{km}` for `\delta_{kl}\delta_{jm}`; the factors are shown as a whole.
  void indices_between(TokenView term) {
    std::vector<std::pair<std::size_t, const Token*>> indices;
    const std::vector<TokenView> subscripts = subscripts_of(term);
    for (std::size_t k = 0; k < subscripts.size(); ++k) {
      for (const Token* index : indices_in(subscripts[k])) indices.emplace_back(k, index);
    }
    std::size_t count = 0;
    for (std::size_t apart = 1; apart < subscripts.size(); ++apart) {
      for (std::size_t a = 0; a < indices.size(); ++a) {
        for (std::size_t b = a + 1; b < indices.size(); ++b) {
          const bool wanted = indices[b].first - indices[a].first == apart &&
                              indices[a].second->kind == indices[b].second->kind;
          if (wanted && ++count <= most_exchanges)
            exchange(Slip::indices_exchanged, {indices[a].second, 1}, {indices[b].second, 1});
        }
      }
    }
  }

  /// Letters near each other with one face.
  void letters_within(TokenView term) {
    constexpr std::size_t furthest = 3;
    const std::vector<PlacedLetter> letters = letters_in(term);
    for (std::size_t apart = 1; apart <= furthest; ++apart) {
      for (std::size_t k = 0; k + apart < letters.size(); ++k) {
        const PlacedLetter& one = letters[k];
        const PlacedLetter& other = letters[k + apart];
        if (one.face == other.face)
          exchange(Slip::letters_exchanged, term.subspan(one.at, 1), term.subspan(other.at, 1));
      }
    }
  }

  /// What may be missing before a term: the plain factors of the chain, and their letters.
  void collect_factors() {
    constexpr std::size_t most = 10;
    std::set<std::string> known;
    const auto collect = [&](TokenView tokens) {
      if (factors_.size() < most && !tokens.empty() && known.insert(text_of(tokens)).second)
        factors_.push_back(tokens);
    };
    for (const TokenView side : chain_) {
      for (const PieceLevel& level : levels_of(side)) {
        if (!level.may_be_sum) continue;
        for (const Piece& piece : level.pieces) {
          if (!is_plain_letter(piece)) continue;
          collect(piece.tokens);
          collect(piece.tokens.first(1));
        }
      }
    }
  }

  /// One letter without a face, with its scripts.
  static bool is_plain_letter(const Piece& piece) {
    if (piece.kind != PieceKind::factor) return false;
    const std::vector<PlacedLetter> letters = letters_in(piece.tokens.first(1));
    return letters.size() == 1 && letters[0].at == 0;
  }

  void missing_factors(TokenView term) {
    std::size_t digits = 0;
    while (is_kind_at(term, digits, TokenKind::digit)) ++digits;
    if (is_control_of(term[0], {"frac", "tfrac", "dfrac"})) {
      const Argument lower = argument_at(term, argument_at(term, 1).next);
      const bool number = std::ranges::all_of(
          lower.content, [](const Token& token) { return token.kind == TokenKind::digit; });
      if (number) digits = lower.next;
    }
    missing_factors_at(place(term) + digits, term);
    // `\cos\omega_2` may have been `\cos\omega_2 t`.
    const bool of_function = std::ranges::any_of(term, [](const Token& token) {
      return is_control_of(token, {"sin", "cos", "tan", "sinh", "cosh", "tanh", "exp", "ln", "log"});
    });
    if (of_function) missing_factors_at(place(term) + term.size(), term);
    if (!components_.empty() && !subscripts_of(term).empty()) missing_components(term);
  }

  /// `a_i` may have been `a_ib_i`, `\delta_{ij}` may have been `\delta_{ij}a_j`.
  void missing_components(TokenView term) {
    const std::size_t end = place(term) + term.size();
    for (const Tokens& component : components_) add(Slip::factor_missing, end, end, component, term);
  }

  /// What has indices in the chain, with one of them replaced, and the components of its vectors.
  void collect_components() {
    constexpr std::size_t most_indices = 6;
    std::vector<Token> indices;
    for (const TokenView side : chain_) {
      for (const TokenView subscript : subscripts_of(side)) {
        for (const Token* index : indices_in(subscript)) {
          const bool known = std::ranges::count(indices, index->text, &Token::text) > 0;
          if (index->kind == TokenKind::letter && !known && indices.size() < most_indices)
            indices.push_back(*index);
        }
      }
    }
    if (indices.empty()) return;
    for (const TokenView side : chain_) {
      for (const PieceLevel& level : levels_of(side)) {
        for (const Piece& piece : level.pieces) {
          if (level.may_be_sum && piece.kind == PieceKind::factor) add_components(piece, indices);
        }
      }
    }
  }

  void add_components(const Piece& piece, const std::vector<Token>& indices) {
    constexpr std::size_t most = 40;
    const auto add_component = [&](Tokens tokens) {
      const auto same = [&](const Tokens& other) { return text_of(other) == text_of(tokens); };
      if (components_.size() < most && std::ranges::none_of(components_, same))
        components_.push_back(std::move(tokens));
    };
    const std::vector<PlacedLetter> letters = letters_in(piece.tokens);
    const std::vector<TokenView> subscripts = subscripts_of(piece.tokens);
    if (letters.size() != 1 || letters[0].begin != 0 || subscripts.size() > 1) return;
    if (subscripts.empty() && !letters[0].face.empty() && letters[0].end == piece.tokens.size()) {
      for (const Token& index : indices)
        add_component({piece.tokens[letters[0].at], made(TokenKind::subscript, "_", 0), index});
    }
    if (subscripts.empty() || !letters[0].face.empty()) return;
    for (const Token* at : indices_in(subscripts[0])) {
      if (at->kind != TokenKind::letter) return;
    }
    for (const Token* at : indices_in(subscripts[0])) {
      for (const Token& index : indices) {
        Tokens component(piece.tokens.begin(), piece.tokens.end());
        component[static_cast<std::size_t>(at - piece.tokens.data())].text = index.text;
        add_component(std::move(component));
      }
    }
  }

  void missing_factors_at(std::size_t at, TokenView shown) {
    for (const TokenView factor : factors_)
      add(Slip::factor_missing, at, at, {factor.begin(), factor.end()}, shown);
  }

  void extra_factors(const PieceLevel& level) {
    const auto is_factor = [&](std::size_t at) {
      return at < level.pieces.size() && level.pieces[at].kind == PieceKind::factor;
    };
    for (std::size_t k = 0; k < level.pieces.size(); ++k) {
      const Piece& piece = level.pieces[k];
      const bool alone = !(k > 0 && is_factor(k - 1)) && !is_factor(k + 1);
      const std::size_t at = place(piece.tokens);
      if (!alone && is_plain_letter(piece))
        add(Slip::factor_extra, at, at + piece.tokens.size(), {}, piece.tokens);
    }
  }

  /// `b/a` for `a/b`.
  void quotients(const PieceLevel& level) {
    for (std::size_t k = 1; k + 1 < level.pieces.size(); ++k) {
      const bool divides = is_sign(level.pieces[k].tokens[0], "/");
      if (divides) exchange(Slip::inverted, level.pieces[k - 1].tokens, level.pieces[k + 1].tokens);
    }
  }

  void fraction(std::size_t k) {
    if (!is_fraction(side_[k])) return;
    const Argument upper = argument_at(side_, k + 1);
    const Argument lower = argument_at(side_, upper.next);
    if (upper.content.empty() || lower.content.empty() || differentiates(lower.content)) return;
    const TokenView whole = side_.subspan(k, lower.next - k);
    const bool braced = is_kind_at(side_, upper.next, TokenKind::begin_group);
    if (braced == is_kind_at(side_, k + 1, TokenKind::begin_group))
      exchange(Slip::inverted, upper.content, lower.content);
    if (!braced) return;
    // A number in the denominator: 2 more, or without it.
    const std::size_t at = place(lower.content);
    std::size_t digits = 0;
    while (is_kind_at(lower.content, digits, TokenKind::digit)) ++digits;
    if (digits == 0) {
      for (const std::string_view number : {"2", "4"})
        add(Slip::factor, at, at, {made(TokenKind::digit, number, at)}, whole);
    } else if (digits < lower.content.size()) {
      add(Slip::factor, at, at + digits, {}, whole);
    }
  }

  /// `24` for `4`: a digit too many.
  void digit_too_many(std::size_t k) {
    if (side_[k].kind != TokenKind::digit) return;
    const bool first = k == 0 || side_[k - 1].kind != TokenKind::digit;
    const bool more = is_kind_at(side_, k + 1, TokenKind::digit);
    const bool another = !first && side_[k - 1].text != side_[k].text;
    if (first ? more : another) add(Slip::factor, k, k + 1, {}, number_around(k));
  }

  TokenView number_around(std::size_t k) const {
    std::size_t begin = k;
    std::size_t end = k + 1;
    while (begin > 0 && side_[begin - 1].kind == TokenKind::digit) --begin;
    while (is_kind_at(side_, end, TokenKind::digit)) ++end;
    return side_.subspan(begin, end - begin);
  }

  void function(std::size_t k) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 10> neighbours{{
        {"sin", "cos"},
        {"sinh", "cosh"},
        {"tan", "cot"},
        {"tanh", "coth"},
        {"sec", "csc"},
        {"sin", "sinh"},
        {"cos", "cosh"},
        {"tan", "tanh"},
        {"arcsin", "arccos"},
        {"exp", "ln"},
    }};
    if (side_[k].kind != TokenKind::control) return;
    bool is_function = false;
    for (const auto& [one, other] : neighbours) {
      for (const auto& [from, to] : {std::pair(one, other), std::pair(other, one)}) {
        if (side_[k].text != from) continue;
        is_function = true;
        add(Slip::function, k, k + 1, {made(TokenKind::control, to, k)}, side_.subspan(k, 1));
      }
    }
    if (is_function && !is_kind_at(side_, k + 1, TokenKind::superscript))
      add(Slip::power, k + 1, k + 1, {made(TokenKind::superscript, "^", k), made(TokenKind::digit, "2", k)},
          side_.subspan(k, 1));
  }

  void rate(std::size_t k) {
    if (dots_of(side_[k]) == 0) return;
    const Argument under = argument_at(side_, k + 1);
    const TokenView whole = side_.subspan(k, under.next - k);
    add(Slip::rate, k, under.next, Tokens(under.content.begin(), under.content.end()), whole);
    add(Slip::rate, k, k + 1, {made(TokenKind::control, dots_of(side_[k]) == 1 ? "ddot" : "dot", k)}, whole);
  }

  /// Another letter of the chain with the same face; a dot or a prime more or less.
  void letters() {
    const std::vector<FacedLetter> others = letters_of_sides(chain_);
    for (const PlacedLetter& letter : letters_in(side_)) {
      replace(letter, others);
      dot_and_prime(letter, side_.subspan(letter.begin, letter.end - letter.begin));
    }
  }

  void dot_and_prime(const PlacedLetter& letter, TokenView whole) {
    if (never_changes(whole)) return;
    if (is_sign_at(side_, letter.end, "'")) {
      add(Slip::prime, letter.end, letter.end + 1, {}, whole);
      return;
    }
    const auto is_rate = [&](std::size_t at) { return at < side_.size() && dots_of(side_[at]) > 0; };
    if (letter.begin > 0 &&
        (is_rate(letter.begin - 1) || side_[letter.begin - 1].kind == TokenKind::superscript))
      return;
    if (letter.begin > 1 && is_rate(letter.begin - 2)) return;
    add(Slip::prime, letter.end, letter.end, {made(TokenKind::other, "'", letter.at)}, whole);
    Tokens dotted{made(TokenKind::control, "dot", letter.at), made(TokenKind::begin_group, "{", letter.at)};
    dotted.insert(dotted.end(), whole.begin(), whole.end());
    dotted.push_back(made(TokenKind::end_group, "}", letter.at));
    add(Slip::rate, letter.begin, letter.end, std::move(dotted), whole);
  }

  TokenView side_;
  const std::vector<TokenView>& chain_;
  bool differentiates_ = std::ranges::any_of(chain_, differentiates);
  std::vector<TokenView> factors_;
  std::vector<Tokens> components_;
  std::vector<Rewriting> rewritings_;
  std::set<std::tuple<std::size_t, std::size_t, std::string>> known_;
};

}  // namespace

std::vector<Rewriting> exchanges_of(TokenView side, const std::vector<TokenView>& chain) {
  return side.empty() ? std::vector<Rewriting>{} : Exchanger(side, chain).all();
}

std::vector<Rewriting> letters_from(const std::vector<TokenView>& near, TokenView side,
                                    const std::vector<TokenView>& chain) {
  return side.empty() ? std::vector<Rewriting>{} : Exchanger(side, chain).with_letters_of(near);
}

}  // namespace rigor
