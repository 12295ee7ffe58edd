// SPDX-License-Identifier: GPL-3.0-or-later
// Terms that may be missing: those that a product of brackets has when it is multiplied out, and those that a
// derivative of fields may have.
#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "latex/reading/placed_letters.h"
#include "latex/reading/rewritings.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

constexpr std::size_t most_expanded = 48;

/// A part of a term, and what may stand there instead.
struct FactorChoice {
  TokenView part;
  std::vector<Tokens> instead;
};

std::vector<Tokens> summands_of(TokenView inside) {
  std::vector<Tokens> summands;
  for (const SideTerm& term : terms_of_side(inside)) summands.push_back(without_layout(term.tokens));
  return summands;
}

Tokens joined(const Tokens& a, const Tokens& b) {
  Tokens all = a;
  all.insert(all.end(), b.begin(), b.end());
  return all;
}

/// `(a + b)` may be a or b; `(a + b)^2` may be a^2, b^2 or ab.
std::optional<FactorChoice> choice_of_bracket(const Piece& piece) {
  const bool bracket = is_sign_of(piece.tokens[0], "([") || is_bracket_size(piece.tokens[0]);
  if (piece.kind != PieceKind::factor || piece.inside.empty() || !bracket) return std::nullopt;
  const std::vector<Tokens> summands = summands_of(piece.inside);
  if (summands.size() < 2 || summands.size() > 4) return std::nullopt;
  const std::size_t end =
      static_cast<std::size_t>(piece.tokens.data() + piece.tokens.size() - piece.inside.data());
  const TokenView behind(piece.inside.data() + piece.inside.size(), end - piece.inside.size());
  const auto raised = std::ranges::find(behind, TokenKind::superscript, &Token::kind);
  if (raised == behind.end()) return FactorChoice{piece.tokens, summands};
  const auto power = static_cast<std::size_t>(raised - behind.begin());
  if (text_of(argument_at(behind, power + 1).content) != "2") return std::nullopt;
  FactorChoice choice{piece.tokens, {}};
  for (std::size_t a = 0; a < summands.size(); ++a) {
    for (std::size_t b = a + 1; b < summands.size(); ++b)
      choice.instead.push_back(joined(summands[a], summands[b]));
  }
  return choice;
}

/// `\frac{a + b}{c}` may be `\frac{a}{c}` or `\frac{b}{c}`.
std::optional<FactorChoice> choice_of_fraction(const Piece& piece) {
  if (!is_fraction(piece.tokens[0])) return std::nullopt;
  const Argument upper = argument_at(piece.tokens, 1);
  const std::vector<Tokens> summands = summands_of(upper.content);
  if (summands.size() < 2 || summands.size() > 4) return std::nullopt;
  return FactorChoice{upper.content, summands};
}

/// All ways to choose.
void expand(TokenView term, const std::vector<FactorChoice>& choices, std::vector<Tokens>& expanded) {
  std::vector<std::size_t> chosen(choices.size(), 0);
  while (expanded.size() < most_expanded) {
    Tokens text;
    const Token* at = term.data();
    for (std::size_t k = 0; k < choices.size(); ++k) {
      text.insert(text.end(), at, choices[k].part.data());
      const Tokens& instead = choices[k].instead[chosen[k]];
      text.insert(text.end(), instead.begin(), instead.end());
      at = choices[k].part.data() + choices[k].part.size();
    }
    text.insert(text.end(), at, term.data() + term.size());
    expanded.push_back(without_layout(text));
    std::size_t k = 0;
    while (k < choices.size() && ++chosen[k] == choices[k].instead.size()) chosen[k++] = 0;
    if (k == choices.size()) return;
  }
}

Tokens written(std::string_view form, TokenView a, TokenView b) {
  static constexpr std::array<std::pair<char, std::string_view>, 3> controls{
      {{'n', "nabla"}, {'.', "cdot"}, {'x', "times"}}};
  const Span at = span_of(a);
  Tokens tokens;
  for (const char& sign : form) {
    if (sign == 'A' || sign == 'B') {
      const TokenView letter = sign == 'A' ? a : b;
      tokens.insert(tokens.end(), letter.begin(), letter.end());
      continue;
    }
    const auto control = std::ranges::find(controls, sign, &std::pair<char, std::string_view>::first);
    if (control != controls.end()) {
      tokens.push_back({TokenKind::control, control->second, at});
    } else if (sign == '^') {
      tokens.push_back({TokenKind::superscript, "^", at});
    } else if (sign == '2') {
      tokens.push_back({TokenKind::digit, "2", at});
    } else {
      tokens.push_back({TokenKind::other, sign == '(' ? "(" : ")", at});
    }
  }
  return tokens;
}

}  // namespace

std::vector<Tokens> expanded_terms_of(TokenView side) {
  std::vector<Tokens> expanded;
  const std::vector<PieceLevel> levels = levels_of(side);
  for (const PieceTerm& term : terms_of(levels.front())) {
    std::vector<FactorChoice> choices;
    for (const Piece& piece : levels.front().pieces) {
      const bool inside = piece.tokens.data() >= term.tokens.data() &&
                          piece.tokens.data() < term.tokens.data() + term.tokens.size();
      if (!inside) continue;
      auto choice = choice_of_bracket(piece);
      if (!choice) choice = choice_of_fraction(piece);
      if (choice && !choice->instead.empty()) choices.push_back(*std::move(choice));
    }
    if (!choices.empty()) expand(term.tokens, choices, expanded);
  }
  return expanded;
}

std::vector<Tokens> field_terms_of(const std::vector<TokenView>& chain) {
  const bool has_nabla = std::ranges::any_of(chain, [](TokenView side) {
    return std::ranges::any_of(side, [](const Token& token) { return is_control(token, "nabla"); });
  });
  if (!has_nabla) return {};
  // Of scalars f, g and vectors A, B: which letters a form takes.
  static constexpr std::array<std::string_view, 2> of_scalars{"AnB", "nA.nB"};
  static constexpr std::array<std::string_view, 4> of_both{"An.B", "B.nA", "nAxB", "AnxB"};
  static constexpr std::array<std::string_view, 6> of_vectors{"(A.n)B",  "Ax(nxB)", "A(n.B)",
                                                              "B.(nxA)", "n(A.B)",  "nx(AxB)"};
  const std::vector<TokenView> letters = letters_of(chain);
  std::vector<Tokens> terms;
  for (const TokenView a : letters) {
    const bool vector = a.size() > 1;
    for (const std::string_view form : {"n^2A", vector ? "n(n.A)" : "nA", vector ? "nx(nxA)" : "A"})
      terms.push_back(written(form, a, a));
    for (const TokenView b : letters) {
      if (text_of(a) == text_of(b)) continue;
      const bool other = b.size() > 1;
      if (!vector && !other) {
        for (const std::string_view form : of_scalars) terms.push_back(written(form, a, b));
      } else if (!vector) {
        for (const std::string_view form : of_both) terms.push_back(written(form, a, b));
      } else if (other) {
        for (const std::string_view form : of_vectors) terms.push_back(written(form, a, b));
      }
    }
  }
  return terms;
}

}  // namespace rigor
