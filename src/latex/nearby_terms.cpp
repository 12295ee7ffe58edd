// SPDX-License-Identifier: GPL-3.0-or-later
// Terms made of what stands near by: the letters of a chain, their products, and terms in brackets.
#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "latex/rewritings.h"

namespace rigor {

bool takes_what_follows(const Token& token) {
  return is_control(token, "frac") || is_control(token, "nabla") || is_control(token, "partial") ||
         is_control(token, "int") || is_control(token, "cos") || is_control(token, "sin");
}

std::size_t end_of_letter(TokenView tokens) {
  if (tokens.empty()) return 0;
  if (tokens[0].kind == TokenKind::letter) return 1;
  if (tokens[0].kind != TokenKind::control || takes_what_follows(tokens[0])) return 0;
  static const std::set<std::string_view> faces{"mathbf", "vec", "boldsymbol", "bm", "vb", "va", "hat"};
  if (faces.contains(tokens[0].text)) return argument_at(tokens, 1).next;
  static const std::set<std::string_view> greek{"omega", "Omega", "theta", "phi", "psi", "tau", "lambda"};
  return greek.contains(tokens[0].text) ? 1 : 0;
}

std::vector<TokenView> letters_of(const std::vector<TokenView>& chain) {
  constexpr std::size_t most = 8;
  std::vector<TokenView> letters;
  for (const TokenView side : chain) {
    for (const PieceLevel& level : levels_of(side)) {
      for (const Piece& piece : level.pieces) {
        if (!level.may_be_sum || piece.kind != PieceKind::factor) continue;
        const TokenView letter = piece.tokens.first(end_of_letter(piece.tokens));
        const bool known = std::any_of(letters.begin(), letters.end(),
                                       [&](TokenView other) { return text_of(other) == text_of(letter); });
        if (!letter.empty() && !known && letters.size() < most) letters.push_back(letter);
      }
    }
  }
  return letters;
}

std::vector<Tokens> products_of(const std::vector<TokenView>& letters) {
  std::vector<Tokens> products;
  const auto join = [&](TokenView first, const Tokens& between, TokenView second) {
    Tokens product(first.begin(), first.end());
    product.insert(product.end(), between.begin(), between.end());
    product.insert(product.end(), second.begin(), second.end());
    products.push_back(std::move(product));
  };
  for (std::size_t a = 0; a < letters.size(); ++a) {
    const Span at = span_of(letters[a]);
    const bool face = letters[a].size() > 1;
    if (!face) join(letters[a], {{TokenKind::superscript, "^", at}, {TokenKind::digit, "2", at}}, {});
    for (std::size_t b = a + 1; b < letters.size(); ++b) {
      if ((letters[b].size() > 1) != face) continue;
      if (!face) join(letters[a], {}, letters[b]);
      if (face) join(letters[a], {{TokenKind::control, "cdot", at}}, letters[b]);
      if (face) join(letters[a], {{TokenKind::control, "times", at}}, letters[b]);
    }
  }
  return products;
}

namespace {

/// All terms and all factors of a chain, each once.
std::vector<Tokens> pool_of(const std::vector<TokenView>& chain) {
  constexpr std::size_t most = 24;
  std::vector<Tokens> pool;
  std::set<std::string> known;
  const auto add = [&](TokenView tokens) {
    Tokens bare = without_layout(tokens);
    const bool number = !bare.empty() && bare[0].kind == TokenKind::digit;
    if (pool.size() < most && !bare.empty() && !number && known.insert(text_of(bare)).second)
      pool.push_back(std::move(bare));
  };
  for (const TokenView side : chain) {
    for (const PieceLevel& level : levels_of(side)) {
      if (!level.may_be_sum) continue;
      for (const PieceTerm& term : terms_of(level)) add(term.tokens);
      for (const Piece& piece : level.pieces) {
        if (piece.kind == PieceKind::factor && end_of_letter(piece.tokens) > 0) add(piece.tokens);
      }
    }
  }
  return pool;
}

}  // namespace

std::vector<Rewriting> insertions_of(TokenView side, const std::vector<TokenView>& chain) {
  const std::vector<Tokens> pool = pool_of(chain);
  std::vector<Rewriting> insertions;
  for (const PieceLevel& level : levels_of(side)) {
    if (level.whole_side || !level.may_be_sum || level.pieces.empty()) continue;
    const TokenView whole{level.pieces.front().tokens.data(),
                          level.pieces.back().tokens.data() + level.pieces.back().tokens.size()};
    std::vector<Tokens> terms = pool;
    for (const PieceTerm& own : terms_of(level)) {
      for (Tokens& image : images_of_term(own.tokens, {whole})) terms.push_back(std::move(image));
    }
    for (const Tokens& term : terms) {
      for (const long sign : {1, -1}) {
        Rewriting change = with_term(whole, term, {sign, 1});
        const auto offset = static_cast<std::size_t>(whole.data() - side.data());
        change.begin += offset;
        change.end += offset;
        change.shown_begin = offset;
        change.shown_end = offset + whole.size();
        insertions.push_back(std::move(change));
      }
    }
  }
  return insertions;
}

}  // namespace rigor
