// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/reading/rewritings.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <tuple>
#include <utility>

#include "latex/reading/exchanges.h"
#include "latex/reading/placed_letters.h"
#include "latex/reading/rearrangements.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

/// Letters stand for letters, digits for digits; the labels of particles are Greek and stay.
bool is_index(const Token& token) {
  return token.kind == TokenKind::letter || token.kind == TokenKind::digit;
}

class Rewriter {
 public:
  explicit Rewriter(TokenView side) : side_(side) {}

  std::vector<Rewriting> all(const std::vector<TokenView>& chain, bool whole_side) {
    for (const PieceLevel& level : levels_with_exponents(side_)) {
      if (!level.may_be_sum) continue;
      if (whole_side || !level.whole_side) terms(level);
      for (std::size_t k = 0; k < level.pieces.size(); ++k) product(level, k);
      for (const Piece& piece : level.pieces) factor(piece);
    }
    subscripts(chain);
    letters(chain);
    return std::move(rewritings_);
  }

 private:
  std::size_t place(TokenView part) const { return static_cast<std::size_t>(part.data() - side_.data()); }
  Token made(TokenKind kind, std::string_view text, TokenView beside) const {
    const Span span = span_of(beside);
    return {kind, text, {span.file, span.begin, span.begin}};
  }

  void add(Slip slip, TokenView from, Tokens to, TokenView shown) {
    Rewriting change{
        .slip = slip, .begin = place(from), .end = place(from) + from.size(), .text = std::move(to)};
    change.shown_begin = std::min(place(shown), change.begin);
    change.shown_end = std::max(place(shown) + shown.size(), change.end);
    std::string key;
    for (const Token& token : change.text) key += std::string(token.text) + " ";
    if (known_.insert({change.begin, change.end, std::move(key)}).second)
      rewritings_.push_back(std::move(change));
  }
  void remove(Slip slip, TokenView from, TokenView shown) { add(slip, from, {}, shown); }
  void insert_behind(Slip slip, TokenView at, Tokens what, TokenView shown) {
    add(slip, at.subspan(at.size()), std::move(what), shown);
  }

  /// Inside brackets; those of the whole side are compared term by term.
  void terms(const PieceLevel& level) {
    const std::vector<PieceTerm> terms = terms_of(level);
    if (terms.empty()) return;
    const TokenView whole{level.pieces.front().tokens.data(),
                          level.pieces.back().tokens.data() + level.pieces.back().tokens.size()};
    for (std::size_t k = 0; k < terms.size(); ++k) {
      constexpr Coefficient choices[] = {{-1, 1}, {2, 1}, {1, 2}, {0, 1}};
      for (const Coefficient times : choices) {
        if (times.numerator == 0 && terms.size() < 2) continue;
        const Rewriting inner = with_coefficient(whole, k, times);
        Rewriting change = inner;
        const std::size_t offset = place(whole);
        for (std::size_t* at : {&change.begin, &change.end, &change.shown_begin, &change.shown_end})
          *at += offset;
        rewritings_.push_back(std::move(change));
      }
    }
  }

  void product(const PieceLevel& level, std::size_t k) {
    const Piece& piece = level.pieces[k];
    if (piece.kind != PieceKind::cross && piece.kind != PieceKind::product) return;
    if (k == 0 || k + 1 == level.pieces.size()) return;
    const Piece& left = level.pieces[k - 1];
    const Piece& right = level.pieces[k + 1];
    const TokenView shown{left.tokens.data(), right.tokens.data() + right.tokens.size()};
    const bool dot = is_control(piece.tokens[0], "cdot") || is_control(piece.tokens[0], "vdot");
    if (dot) add(Slip::product, piece.tokens, {made(TokenKind::control, "times", piece.tokens)}, shown);
    if (piece.kind != PieceKind::cross) return;
    add(Slip::product, piece.tokens, {made(TokenKind::control, "cdot", piece.tokens)}, shown);
    Tokens exchanged(right.tokens.begin(), right.tokens.end());
    exchanged.insert(exchanged.end(), piece.tokens.begin(), piece.tokens.end());
    exchanged.insert(exchanged.end(), left.tokens.begin(), left.tokens.end());
    add(Slip::order, shown, std::move(exchanged), shown);
  }

  void factor(const Piece& piece) {
    if (piece.kind == PieceKind::bars) brackets_for_bars(piece);
    if (piece.kind == PieceKind::factor) bars_for_brackets(piece);
    if (piece.kind != PieceKind::factor && piece.kind != PieceKind::bars) return;
    power(piece);
    rates_and_primes(piece);
  }

  void brackets_for_bars(const Piece& piece) {
    if (piece.inside.data() == nullptr) return;
    const std::size_t inside = place(piece.inside) - place(piece.tokens);
    const TokenView before = piece.tokens.first(inside);
    const TokenView behind = piece.tokens.subspan(inside + piece.inside.size());
    std::size_t closing = 0;
    while (closing < behind.size() && behind[closing].kind != TokenKind::superscript &&
           behind[closing].kind != TokenKind::subscript)
      ++closing;
    Tokens to{made(TokenKind::other, "(", before)};
    to.insert(to.end(), piece.inside.begin(), piece.inside.end());
    to.push_back(made(TokenKind::other, ")", before));
    add(Slip::bars, piece.tokens.first(inside + piece.inside.size() + closing), std::move(to), piece.tokens);
  }

  void bars_for_brackets(const Piece& piece) {
    std::size_t opening = 0;
    while (opening < piece.tokens.size() && is_bracket_size(piece.tokens[opening])) ++opening;
    if (!is_sign_at(piece.tokens, opening, "(") || piece.inside.empty()) return;
    const std::size_t inside = place(piece.inside) - place(piece.tokens);
    std::size_t closing = inside + piece.inside.size();
    while (closing < piece.tokens.size() && !is_sign(piece.tokens[closing], ")")) ++closing;
    if (closing >= piece.tokens.size()) return;
    Tokens to{made(TokenKind::other, "|", piece.tokens)};
    to.insert(to.end(), piece.inside.begin(), piece.inside.end());
    to.push_back(made(TokenKind::other, "|", piece.tokens));
    add(Slip::bars, piece.tokens.first(closing + 1), std::move(to), piece.tokens);
  }

  void power(const Piece& piece) {
    const TokenView tokens = piece.tokens;
    std::size_t depth = 0;
    for (std::size_t k = 0; k < tokens.size(); ++k) {
      if (tokens[k].kind == TokenKind::begin_group) ++depth;
      if (tokens[k].kind == TokenKind::end_group && depth > 0) --depth;
      if (depth > 0 || tokens[k].kind != TokenKind::superscript) continue;
      const Argument exponent = argument_at(tokens, k + 1);
      const TokenView whole = tokens.subspan(k, exponent.next - k);
      const std::string text = text_of(exponent.content);
      for (const std::string_view other : {"1", "2", "3"}) {
        if (other == text || (text != "2" && text != "3" && text != "4")) continue;
        Tokens to;
        if (other != "1") {
          to = {made(TokenKind::superscript, "^", whole), made(TokenKind::digit, other, whole)};
        }
        add(Slip::power, whole, std::move(to), tokens);
      }
      return;
    }
    if (tokens[0].kind == TokenKind::digit || takes_what_follows(tokens[0])) return;
    insert_behind(Slip::power, tokens,
                  {made(TokenKind::superscript, "^", tokens), made(TokenKind::digit, "2", tokens)}, tokens);
  }

  void rates_and_primes(const Piece& piece) {
    const TokenView tokens = piece.tokens;
    for (std::size_t k = 0; k < tokens.size(); ++k) {
      const bool one = is_control(tokens[k], "dot");
      if (!one && !is_control(tokens[k], "ddot")) continue;
      const Argument under = argument_at(tokens, k + 1);
      const TokenView whole = tokens.subspan(k, under.next - k);
      add(Slip::rate, whole, Tokens(under.content.begin(), under.content.end()), tokens);
      add(Slip::rate, tokens.subspan(k, 1), {made(TokenKind::control, one ? "ddot" : "dot", whole)}, tokens);
      return;
    }
    const std::size_t letter = end_of_letter(tokens);
    if (letter == 0) return;
    const TokenView base = tokens.first(letter);
    if (never_changes(base)) return;
    Tokens dotted{made(TokenKind::control, "dot", tokens), made(TokenKind::begin_group, "{", tokens)};
    dotted.insert(dotted.end(), base.begin(), base.end());
    dotted.push_back(made(TokenKind::end_group, "}", tokens));
    add(Slip::rate, base, std::move(dotted), tokens);
    if (is_sign_at(tokens, letter, "'")) {
      remove(Slip::prime, tokens.subspan(letter, 1), tokens);
    } else {
      insert_behind(Slip::prime, base, {made(TokenKind::other, "'", tokens)}, tokens);
    }
  }

  void subscripts(const std::vector<TokenView>& chain) {
    std::vector<Token> occurring;
    for (const TokenView side : chain) {
      for (const TokenView subscript : subscripts_of(side)) {
        for (const Token* token : indices_in(subscript)) {
          const bool known = std::ranges::any_of(occurring, [&](const Token& other) {
            return other.kind == token->kind && other.text == token->text;
          });
          if (!known) occurring.push_back(*token);
        }
      }
    }
    complete(occurring, TokenKind::digit, {"1", "2", "3"});
    complete(occurring, TokenKind::letter, {"x", "y", "z"});
    for (const TokenView subscript : subscripts_of(side_)) {
      const std::vector<const Token*> found = indices_in(subscript);
      for (std::size_t first = 0; first < found.size(); ++first) {
        const TokenView at(found[first], 1);
        for (std::size_t second = first + 1; second < found.size(); ++second)
          between(subscript, *found[first], *found[second]);
        for (const Token& other : occurring) {
          if (other.kind == at[0].kind && other.text != at[0].text)
            add(Slip::index, at, {made(other.kind, other.text, at)}, subscript);
        }
        const bool primed = place(at) + 1 < side_.size() && is_sign(side_[place(at) + 1], "'");
        if (primed) remove(Slip::index, side_.subspan(place(at) + 1, 1), subscript);
        if (!primed) insert_behind(Slip::index, at, {made(TokenKind::other, "'", at)}, subscript);
      }
    }
  }

  /// Where one of the axes is named, any of them can be meant.
  static void complete(std::vector<Token>& occurring, TokenKind kind,
                       const std::array<std::string_view, 3>& axes) {
    const auto is_there = [&](std::string_view axis) {
      return std::ranges::any_of(
          occurring, [&](const Token& token) { return token.kind == kind && token.text == axis; });
    };
    if (std::ranges::none_of(axes, is_there)) return;
    for (const std::string_view axis : axes) {
      if (!is_there(axis)) occurring.push_back({kind, axis, {}});
    }
  }

  static std::vector<const Token*> indices_in(TokenView subscript) {
    std::vector<const Token*> indices;
    for (const Token& token : subscript) {
      if (is_control(token, "text") || is_control(token, "mathrm")) return {};
      if (is_index(token)) indices.push_back(&token);
    }
    return indices;
  }

  void between(TokenView subscript, const Token& first, const Token& second) {
    exchange(subscript, first, second);
    move_prime(subscript, first, second);
  }

  bool is_primed(const Token& index) const {
    const std::size_t next = place({&index, 1}) + 1;
    return next < side_.size() && is_sign(side_[next], "'");
  }

  /// `j'i` for `ji'`.
  void move_prime(TokenView subscript, const Token& first, const Token& second) {
    const bool from_first = is_primed(first);
    if (from_first == is_primed(second)) return;
    const TokenView all(&first, static_cast<std::size_t>(&second - &first) + (from_first ? 1 : 2));
    Tokens to(all.begin(), all.end());
    if (from_first) {
      std::rotate(to.begin() + 1, to.begin() + 2, to.end());
    } else {
      std::rotate(to.begin() + 1, to.end() - 1, to.end());
    }
    add(Slip::index, all, std::move(to), subscript);
  }

  void exchange(TokenView subscript, const Token& first, const Token& second) {
    if (first.kind != second.kind || first.text == second.text) return;
    const TokenView all(&first, static_cast<std::size_t>(&second - &first) + 1);
    Tokens to(all.begin(), all.end());
    std::swap(to.front(), to.back());
    add(Slip::indices_swapped, all, std::move(to), subscript);
  }

  /// Another letter with the same face that occurs in the chain.
  void letters(const std::vector<TokenView>& chain) {
    const std::vector<TokenView> bases = letters_of(chain);
    for (const PieceLevel& level : levels_of(side_)) {
      for (const Piece& piece : level.pieces) {
        if (!level.may_be_sum || piece.kind != PieceKind::factor) continue;
        const TokenView base = piece.tokens.first(end_of_letter(piece.tokens));
        for (const TokenView other : bases) {
          const bool same_face = !base.empty() && base.size() == other.size() &&
                                 base[0].kind == other[0].kind &&
                                 (base.size() == 1 || base[0].text == other[0].text);
          if (same_face && text_of(base) != text_of(other))
            add(Slip::letter, base, Tokens(other.begin(), other.end()), piece.tokens);
        }
      }
    }
  }

  TokenView side_;
  std::vector<Rewriting> rewritings_;
  std::set<std::tuple<std::size_t, std::size_t, std::string>> known_;
};

/// In braces where it takes the place of the one token that is an argument: `\mathbf{\dot a}`.
void append_in_place(Tokens& tokens, const Tokens& text) {
  const bool braced = text.size() != 1 && !tokens.empty() && takes_one_token(tokens.back()) &&
                      (text.empty() || text.front().kind != TokenKind::begin_group);
  if (braced) tokens.push_back({TokenKind::begin_group, "{", tokens.back().span});
  tokens.insert(tokens.end(), text.begin(), text.end());
  if (braced) tokens.push_back({TokenKind::end_group, "}", tokens.back().span});
}

}  // namespace

bool takes_one_token(const Token& token) {
  return token.kind == TokenKind::superscript || token.kind == TokenKind::subscript || is_fraction(token) ||
         is_control(token, "sqrt") || dots_of(token) > 0 || style_of(token).has_value();
}

Tokens rewritten(TokenView side, const Rewriting& rewriting) {
  Tokens result(side.begin(), side.begin() + static_cast<std::ptrdiff_t>(rewriting.begin));
  append_in_place(result, rewriting.text);
  result.insert(result.end(), side.begin() + static_cast<std::ptrdiff_t>(rewriting.end), side.end());
  return result;
}

Tokens shown_after(TokenView side, const Rewriting& rewriting) {
  const auto part = [&](std::size_t from, std::size_t to) {
    return side.subspan(from, to > from ? to - from : 0);
  };
  const TokenView before = part(rewriting.shown_begin, rewriting.begin);
  const TokenView behind = part(rewriting.end, rewriting.shown_end);
  Tokens result(before.begin(), before.end());
  append_in_place(result, rewriting.text);
  result.insert(result.end(), behind.begin(), behind.end());
  return result;
}

std::vector<Rewriting> rewritings_of(TokenView side, const std::vector<TokenView>& chain, bool whole_side) {
  if (side.empty()) return {};
  std::vector<Rewriting> rewritings = Rewriter(side).all(chain, whole_side);
  const auto is_same = [](const Rewriting& a, const Rewriting& b) {
    return a.begin == b.begin && a.end == b.end && text_of(a.text) == text_of(b.text);
  };
  std::vector<Rewriting> others = exchanges_of(side, chain);
  std::ranges::move(rearrangements_of(side, chain), std::back_inserter(others));
  for (Rewriting& each : others) {
    const bool known =
        std::ranges::any_of(rewritings, [&](const Rewriting& other) { return is_same(each, other); });
    if (!known) rewritings.push_back(std::move(each));
  }
  return rewritings;
}

}  // namespace rigor
