// SPDX-License-Identifier: GPL-3.0-or-later
#include "mutate.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "latex/reading/pieces.h"
#include "latex/token/tokens.h"

namespace rigor::twins {
namespace {

/// Letters stand for letters, digits for digits; the labels of particles are Greek and stay.
bool is_index(const Token& token) {
  return token.kind == TokenKind::letter || token.kind == TokenKind::digit;
}

bool may_stand_for(const Token& token, const Token& other) {
  return is_index(token) && token.kind == other.kind && token.text != other.text;
}

/// The tokens of a subscript that are indices: not those of a word such as `\text{rot}`.
std::vector<const Token*> indices_in(TokenView subscript) {
  std::vector<const Token*> indices;
  for (const Token& token : subscript) {
    if (is_control(token, "text")) return {};
    if (is_index(token)) indices.push_back(&token);
  }
  return indices;
}

/// `\nabla^2`, `d^2x`, `\partial t^2`: how often, not a power.
bool counts_derivatives(TokenView side, std::size_t superscript) {
  const auto is_d = [&](std::size_t at) {
    return is_control(side[at], "nabla") || is_control(side[at], "partial") ||
           (side[at].kind == TokenKind::letter && side[at].text == "d");
  };
  return (superscript > 0 && is_d(superscript - 1)) ||
         (superscript > 1 && (is_d(superscript - 2) ||
                              (superscript > 2 && is_blank(side[superscript - 2]) && is_d(superscript - 3))));
}

/// Each `^2`, both tokens (and braces), but for those of `\nabla^2` and `\partial^2`.
std::vector<TokenView> squares_of(TokenView side) {
  std::vector<TokenView> squares;
  for (std::size_t k = 0; k < side.size(); ++k) {
    if (side[k].kind != TokenKind::superscript || counts_derivatives(side, k)) continue;
    const Argument exponent = argument_at(side, k + 1);
    if (text_of(exponent.content) == "2") squares.push_back(side.subspan(k, exponent.next - k));
  }
  return squares;
}

class Mutator {
 public:
  Mutator(const SourceMap& sources, TokenView side) : sources_(sources), side_(side) {}

  std::vector<Edit> edits(const std::vector<TokenView>& statement) {
    for (const PieceLevel& level : levels_of(side_)) {
      products(level);
      terms(level);
    }
    for (const TokenView square : squares_of(side_)) {
      add(Slip::power, square, " ");
      add(Slip::power, square, "^3");
    }
    indices(statement);
    return std::move(edits_);
  }

 private:
  std::string text(TokenView tokens) const { return std::string(sources_.text(span_of(tokens))); }

  void add(Slip slip, Span span, std::string replacement) {
    if (sources_.text(span) == replacement) return;
    const bool known = std::any_of(edits_.begin(), edits_.end(), [&](const Edit& edit) {
      return edit.span == span && edit.text == replacement;
    });
    if (!known) edits_.push_back({slip, span, std::move(replacement)});
  }
  void add(Slip slip, TokenView tokens, std::string replacement) {
    add(slip, span_of(tokens), std::move(replacement));
  }
  void insert(Slip slip, TokenView before, std::string addition) {
    const Span span = span_of(before);
    add(slip, Span{span.file, span.begin, span.begin}, std::move(addition));
  }

  void products(const PieceLevel& level) {
    for (std::size_t k = 0; k < level.pieces.size(); ++k) {
      const Piece& piece = level.pieces[k];
      if (piece.kind == PieceKind::bars) add(Slip::bars_dropped, piece.tokens, unbarred(piece));
      if (piece.kind != PieceKind::cross) continue;
      add(Slip::cross_to_dot, piece.tokens, "\\cdot");
      if (k == 0 || k + 1 == level.pieces.size()) continue;
      const Piece& left = level.pieces[k - 1];
      const Piece& right = level.pieces[k + 1];
      add(Slip::order, cover(span_of(left.tokens), span_of(right.tokens)),
          fmt::format(" {} {} {}", text(right.tokens), text(piece.tokens), text(left.tokens)));
    }
  }

  /// `|a|^2` becomes `(a)^2`.
  std::string unbarred(const Piece& bars) const {
    const Span inside = span_of(bars.inside);
    const Span all = span_of(bars.tokens);
    std::string tail(sources_.text(Span{all.file, inside.end, all.end}));
    const std::size_t script = tail.find_first_of("^_");
    return fmt::format("({}){}", text(bars.inside), script == std::string::npos ? "" : tail.substr(script));
  }

  void terms(const PieceLevel& level) {
    const std::vector<PieceTerm> terms = terms_of(level);
    if (terms.size() < 2 && !level.whole_side) return;
    for (std::size_t k = 0; k < terms.size(); ++k) {
      if (text(terms[k].tokens) == "0") continue;
      sign(terms[k]);
      factors(terms[k]);
      if (terms.size() > 1) drop(terms, k);
    }
  }

  void sign(const PieceTerm& term) {
    if (term.sign == nullptr) {
      insert(Slip::sign, term.tokens, "-");
    } else {
      add(Slip::sign, term.sign->tokens, term.sign->kind == PieceKind::plus ? "-" : "+");
    }
  }

  void factors(const PieceTerm& term) {
    std::size_t digits = 0;
    while (digits < term.tokens.size() && term.tokens[digits].kind == TokenKind::digit) ++digits;
    if (digits == 0) {
      insert(Slip::factor, term.tokens, "2\\cdot ");
      insert(Slip::factor, term.tokens, "\\frac{1}{2}");
      return;
    }
    const TokenView number = term.tokens.first(digits);
    add(Slip::factor, number, std::to_string(2 * std::stoi(text(number))));
    add(Slip::factor, number, fmt::format("\\frac{{{}}}{{2}}", text(number)));
  }

  /// With its own sign, or for the first term with the plus of the next one.
  void drop(const std::vector<PieceTerm>& terms, std::size_t which) {
    const PieceTerm& term = terms[which];
    Span span = span_of(term.tokens);
    if (term.sign != nullptr) span = cover(span, span_of(term.sign->tokens));
    if (which == 0) {
      const Piece& next = *terms[1].sign;
      const Span sign = span_of(next.tokens);
      span.end = next.kind == PieceKind::plus ? sign.end : sign.begin;
    }
    add(Slip::term_dropped, span, "");
  }

  void indices(const std::vector<TokenView>& statement) {
    std::vector<const Token*> occurring;
    for (const TokenView side : statement) {
      for (const TokenView subscript : subscripts_of(side)) {
        const auto found = indices_in(subscript);
        occurring.insert(occurring.end(), found.begin(), found.end());
      }
    }
    for (const TokenView subscript : subscripts_of(side_)) {
      const std::vector<const Token*> found = indices_in(subscript);
      for (std::size_t first = 0; first < found.size(); ++first) {
        for (std::size_t second = first + 1; second < found.size(); ++second)
          swap(*found[first], *found[second]);
        for (const Token* other : occurring) {
          if (may_stand_for(*found[first], *other))
            add(Slip::index_replaced, found[first]->span, std::string(other->text));
        }
      }
    }
  }

  void swap(const Token& first, const Token& second) {
    if (!may_stand_for(first, second)) return;
    const Span between{first.span.file, first.span.end, second.span.begin};
    add(Slip::indices_swapped, cover(first.span, second.span),
        fmt::format("{}{}{}", second.text, sources_.text(between), first.text));
  }

  const SourceMap& sources_;
  TokenView side_;
  std::vector<Edit> edits_;
};

}  // namespace

std::string_view name_of(Slip slip) {
  static constexpr std::array<std::string_view, slip_count> names{"sign",
                                                                  "indices swapped",
                                                                  "index replaced",
                                                                  "order",
                                                                  "factor",
                                                                  "term dropped",
                                                                  "power",
                                                                  "cross to dot",
                                                                  "bars dropped",
                                                                  "indices exchanged",
                                                                  "terms exchanged",
                                                                  "letters exchanged",
                                                                  "letter replaced",
                                                                  "prime",
                                                                  "dot",
                                                                  "function",
                                                                  "square added",
                                                                  "fraction inverted",
                                                                  "denominator",
                                                                  "factor dropped"};
  return names[static_cast<std::size_t>(slip)];
}

std::vector<Edit> slips_of(const SourceMap& sources, TokenView side,
                           const std::vector<TokenView>& statement) {
  return Mutator(sources, side).edits(statement);
}

std::string with_edit(std::string_view text, std::uint32_t offset, const Edit& edit) {
  const std::string_view before = text.substr(0, edit.span.begin - offset);
  const std::string_view after = text.substr(edit.span.end - offset);
  return fmt::format("{}{}{}", before, edit.text, after);
}

}  // namespace rigor::twins
