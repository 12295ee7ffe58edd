// SPDX-License-Identifier: GPL-3.0-or-later
// Terms made of what stands near by: the letters of a chain, their products, and terms in brackets.
#include <algorithm>
#include <initializer_list>
#include <set>
#include <string_view>
#include <utility>

#include "latex/reading/rewritings.h"

namespace rigor {

bool takes_what_follows(const Token& token) {
  return is_control_of(token, {"frac", "nabla", "partial", "int", "cos", "sin"});
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
        const bool known =
            std::ranges::any_of(letters, [&](TokenView other) { return text_of(other) == text_of(letter); });
        if (!letter.empty() && !known && letters.size() < most) letters.push_back(letter);
      }
    }
  }
  return letters;
}

namespace {

Tokens joined(std::initializer_list<TokenView> parts) {
  Tokens all;
  for (const TokenView part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

bool has_face(TokenView letter) { return letter.size() > 1; }

/// What comes before the first vector of each term, without its number; nothing, too.
std::vector<Tokens> prefixes_of(const std::vector<TokenView>& chain) {
  constexpr std::size_t most = 3;
  std::vector<Tokens> prefixes{{}};
  for (const TokenView side : chain) {
    for (const SideTerm& term : terms_of_side(side)) {
      std::size_t begin = 0;
      while (is_kind_at(term.tokens, begin, TokenKind::digit)) ++begin;
      std::size_t end = begin;
      while (is_kind_at(term.tokens, end, TokenKind::letter)) ++end;
      const bool before_vector = is_kind_at(term.tokens, end, TokenKind::control);
      Tokens prefix(term.tokens.begin() + static_cast<std::ptrdiff_t>(begin),
                    term.tokens.begin() + static_cast<std::ptrdiff_t>(end));
      const bool known = std::ranges::any_of(
          prefixes, [&](const Tokens& other) { return text_of(other) == text_of(prefix); });
      if (before_vector && !known && prefixes.size() < most) prefixes.push_back(std::move(prefix));
    }
  }
  return prefixes;
}

}  // namespace

std::vector<Tokens> products_of(const std::vector<TokenView>& letters) {
  std::vector<Tokens> products;
  for (std::size_t a = 0; a < letters.size(); ++a) {
    const Span at = span_of(letters[a]);
    const bool face = has_face(letters[a]);
    const Tokens square{{TokenKind::superscript, "^", at}, {TokenKind::digit, "2", at}};
    if (!face) products.push_back(joined({letters[a], square}));
    for (std::size_t b = a + 1; b < letters.size(); ++b) {
      if (has_face(letters[b]) != face) continue;
      if (!face) products.push_back(joined({letters[a], letters[b]}));
      for (const char* sign : {"cdot", "times"}) {
        const Tokens between{{TokenKind::control, sign, at}};
        if (face) products.push_back(joined({letters[a], between, letters[b]}));
      }
    }
  }
  return products;
}

std::vector<Tokens> vector_products_of(const std::vector<TokenView>& chain) {
  constexpr std::size_t most_vectors = 4;
  std::vector<TokenView> vectors = letters_of(chain);
  std::erase_if(vectors, [](TokenView letter) { return !has_face(letter); });
  if (vectors.size() > most_vectors) vectors.erase(vectors.begin() + most_vectors, vectors.end());
  std::vector<Tokens> bodies;
  for (const TokenView a : vectors) {
    const Span at = span_of(a);
    const Tokens cross{{TokenKind::control, "times", at}};
    const Tokens dot{{TokenKind::control, "cdot", at}};
    const Tokens open{{TokenKind::other, "(", at}};
    const Tokens close{{TokenKind::other, ")", at}};
    bodies.push_back(joined({a}));
    for (const TokenView b : vectors) {
      if (text_of(a) != text_of(b)) bodies.push_back(joined({a, cross, b}));
      for (const TokenView c : vectors) {
        bodies.push_back(joined({open, a, dot, b, close, c}));
        if (text_of(b) != text_of(c)) bodies.push_back(joined({a, cross, open, b, cross, c, close}));
      }
    }
  }
  std::vector<Tokens> products;
  for (const Tokens& prefix : prefixes_of(chain)) {
    for (const Tokens& body : bodies) products.push_back(joined({prefix, body}));
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
  const std::vector<TokenView> letters = letters_of(chain);
  const auto face = std::ranges::find_if(letters, has_face);
  for (const TokenView letter : letters) {
    if (face != letters.end() && face->size() == 4 && !has_face(letter))
      add(joined({face->first(2), letter, face->subspan(3)}));
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
    for (const std::string_view number : {"1", "2"})
      terms.push_back({{TokenKind::digit, number, level.pieces.front().tokens[0].span}});
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
