// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/reading/pieces.h"

#include <algorithm>

#include "base/ascii.h"

namespace rigor {
namespace {

bool is_layout_sign(const Token& token) {
  static const WordSet controls("\\ , ; : ! quad qquad notag nonumber");
  return is_blank(token) || token.kind == TokenKind::align || is_control(token, " ") ||
         is_control_of(token, controls);
}

bool is_size(const Token& token) {
  static const WordSet controls("left right big Big bigg Bigg bigl bigr Bigl Bigr biggl biggr Biggl Biggr");
  return is_control_of(token, controls);
}

bool is_length_bar(const Token& token) {
  return is_sign(token, "|") || is_control(token, "lvert") || is_control(token, "rvert");
}

int change_of_depth(const Token& token) {
  if (token.kind == TokenKind::begin_group || is_sign_of(token, "([")) return 1;
  if (token.kind == TokenKind::end_group || is_sign_of(token, ")]")) return -1;
  return 0;
}

/// What is inside of something, to be cut in its turn.
struct Inner {
  TokenView tokens;
  bool may_be_sum = false;
};

/// Controls whose arguments are sums as often as not.
bool takes_sum(const Token& control) {
  static const WordSet controls("frac tfrac dfrac sqrt abs norm qty underbrace boxed");
  return is_control_of(control, controls);
}

/// Cuts one level into pieces; what it passes by on the way down is kept as further levels.
class Cutter {
 public:
  explicit Cutter(TokenView tokens) : tokens_(tokens) {}

  std::vector<Piece> cut(std::vector<Inner>& inner) {
    inner_ = &inner;
    std::vector<Piece> pieces;
    while (at_ < tokens_.size()) {
      if (is_layout_sign(tokens_[at_])) {
        ++at_;
      } else {
        pieces.push_back(piece());
      }
    }
    return pieces;
  }

 private:
  Piece piece() {
    const std::size_t begin = at_;
    const Token& token = tokens_[at_];
    PieceKind kind = PieceKind::factor;
    if (is_sign(token, "+")) kind = PieceKind::plus;
    if (is_sign(token, "-")) kind = PieceKind::minus;
    if (is_control(token, "times") || is_control(token, "cross")) kind = PieceKind::cross;
    if (is_control(token, "cdot") || is_control(token, "vdot") || is_sign(token, "/"))
      kind = PieceKind::product;
    if (kind != PieceKind::factor) {
      ++at_;
      return {kind, tokens_.subspan(begin, 1)};
    }
    Piece factor{kind, {}};
    if (is_control(token, "sum")) factor.kind = PieceKind::big_sum;
    base(factor);
    scripts();
    factor.tokens = tokens_.subspan(begin, at_ - begin);
    return factor;
  }

  void base(Piece& factor) {
    if (is_control(tokens_[at_], "qty")) ++at_;
    if (at_ < tokens_.size() && is_size(tokens_[at_])) ++at_;
    if (at_ >= tokens_.size()) return;
    const Token& token = tokens_[at_];
    if (is_length_bar(token))
      return enclosed(factor, PieceKind::bars, [](const Token& other) { return is_length_bar(other); });
    if (is_sign_of(token, "([")) {
      return enclosed(factor, PieceKind::factor, [](const Token& other) { return is_sign_of(other, ")]"); });
    }
    if (token.kind == TokenKind::digit) return number();
    if (token.kind == TokenKind::begin_group) return arguments(factor, true);
    ++at_;
    if (token.kind == TokenKind::control && factor.kind != PieceKind::big_sum) {
      const bool bars = token.text == "abs" || token.text == "norm";
      const bool fraction = token.text == "frac" || token.text == "tfrac" || token.text == "dfrac";
      if (bars && is_sign_at(tokens_, at_, "*")) ++at_;
      arguments(factor, takes_sum(token));
      if (bars && factor.inside.data() != nullptr) factor.kind = PieceKind::bars;
      while (fraction && is_kind_at(tokens_, at_, TokenKind::digit)) ++at_;
    }
  }

  /// From an opening sign to the closing one of the same depth.
  template <class Closes>
  void enclosed(Piece& factor, PieceKind kind, Closes closes) {
    const std::size_t begin = ++at_;
    std::size_t end = begin;
    for (int depth = 0; end < tokens_.size(); ++end) {
      if (depth == 0 && closes(tokens_[end])) break;
      depth += change_of_depth(tokens_[end]);
    }
    at_ = std::min(end + 1, tokens_.size());
    if (end > begin && is_size(tokens_[end - 1])) --end;
    factor.kind = kind;
    factor.inside = tokens_.subspan(begin, end - begin);
    inner_->push_back({factor.inside, true});
  }

  void number() {
    while (is_kind_at(tokens_, at_, TokenKind::digit)) ++at_;
  }

  void arguments(Piece& factor, bool may_be_sum) {
    while (is_kind_at(tokens_, at_, TokenKind::begin_group)) {
      const Argument argument = argument_at(tokens_, at_);
      factor.inside = argument.content;
      inner_->push_back({argument.content, may_be_sum});
      at_ = argument.next;
    }
  }

  void scripts() {
    while (at_ < tokens_.size() && (is_script(tokens_[at_]))) {
      at_ = is_sign(tokens_[at_], "'") ? at_ + 1 : argument_at(tokens_, at_ + 1).next;
    }
  }

  TokenView tokens_;
  std::size_t at_ = 0;
  std::vector<Inner>* inner_ = nullptr;
};

}  // namespace

std::vector<PieceLevel> levels_of(TokenView side) {
  std::vector<PieceLevel> levels;
  std::vector<Inner> pending{{side, true}};
  for (std::size_t k = 0; k < pending.size(); ++k) {
    const Inner inner = pending[k];
    PieceLevel level{Cutter(inner.tokens).cut(pending), k == 0, inner.may_be_sum};
    levels.push_back(std::move(level));
  }
  return levels;
}

std::vector<PieceTerm> terms_of(const PieceLevel& level) {
  std::vector<PieceTerm> terms;
  const Piece* sign = nullptr;
  for (const Piece& piece : level.pieces) {
    if (piece.kind == PieceKind::plus || piece.kind == PieceKind::minus) {
      sign = &piece;
      continue;
    }
    if (terms.empty() || sign != nullptr) {
      terms.push_back({sign, piece.tokens});
    } else {
      TokenView& tokens = terms.back().tokens;
      tokens = {tokens.data(), piece.tokens.data() + piece.tokens.size()};
    }
    sign = nullptr;
  }
  return terms;
}

std::vector<TokenView> subscripts_of(TokenView side) {
  std::vector<TokenView> subscripts;
  for (std::size_t k = 1; k < side.size(); ++k) {
    if (side[k].kind != TokenKind::subscript || is_control(side[k - 1], "sum")) continue;
    subscripts.push_back(argument_at(side, k + 1).content);
  }
  return subscripts;
}

}  // namespace rigor
