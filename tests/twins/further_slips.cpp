// SPDX-License-Identifier: GPL-3.0-or-later
#include "further_slips.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/ascii.h"
#include "latex/reading/pieces.h"

namespace rigor::twins {
namespace {

bool is_face(const Token& token) {
  return is_control_of(token, {"mathbf", "vec", "boldsymbol", "bm", "vb", "hat", "mathcal", "bar", "tilde"});
}

bool is_rate(const Token& token) { return is_control_of(token, {"dot", "ddot"}); }

bool is_greek(const Token& token) {
  static const WordSet letters(
      "alpha beta gamma delta epsilon zeta eta theta kappa lambda mu nu xi pi rho sigma tau phi varphi chi "
      "psi omega Gamma Delta Theta Lambda Sigma Phi Psi Omega hbar ell");
  return is_control_of(token, letters);
}

/// Their braces hold words, not letters.
bool holds_words(const Token& token) {
  return is_control_of(token, {"text", "mathrm", "operatorname", "textbf", "mbox", "begin", "end", "label"});
}

/// A letter with the face that it has, and where it stands.
struct Letter {
  const Token* token;
  std::string_view face;  // empty: plain
  TokenView whole;        // with its face
};

/// Not those of subscripts, words and differentials.
std::vector<Letter> letters_in(TokenView side) {
  std::vector<Letter> letters;
  for (std::size_t k = 0; k < side.size(); ++k) {
    if (holds_words(side[k])) {
      k = argument_at(side, k + 1).next - 1;
    } else if (side[k].kind == TokenKind::subscript) {
      k = script_argument_at(side, k + 1).next - 1;
    } else if ((side[k].kind == TokenKind::letter && side[k].text != "d") || is_greek(side[k])) {
      const bool braced = k > 1 && side[k - 1].kind == TokenKind::begin_group && is_face(side[k - 2]);
      const bool bare = k > 0 && is_face(side[k - 1]);
      const std::size_t begin = braced ? k - 2 : bare ? k - 1 : k;
      const std::size_t end = braced ? argument_at(side, k - 1).next : k + 1;
      letters.push_back({&side[k], braced || bare ? side[begin].text : std::string_view{},
                         side.subspan(begin, end - begin)});
    }
  }
  return letters;
}

/// A function, an accent or a differential whose argument is what comes next.
bool takes_an_argument(TokenView piece) {
  const Token& token = piece.front();
  if (piece.size() > 1 && piece[1].kind != TokenKind::superscript) return false;
  const bool word = token.kind == TokenKind::control && token.text.size() > 1;
  const bool differential = token.kind == TokenKind::letter && token.text == "d";
  return differential || (word && !is_greek(token) && !is_control_of(token, {"quad", "qquad"}));
}

bool is_same(const Token& a, const Token& b) { return a.kind == b.kind && a.text == b.text; }

class FurtherMutator {
 public:
  FurtherMutator(const SourceMap& sources, TokenView side) : sources_(sources), side_(side) {}

  std::vector<Edit> edits(const std::vector<TokenView>& statement) {
    for (const PieceLevel& level : levels_of(side_)) {
      if (!level.may_be_sum) continue;
      const std::vector<PieceTerm> terms = terms_of(level);
      for (std::size_t k = 0; k < terms.size(); ++k) {
        indices_between(terms[k].tokens);
        letters_within(terms[k].tokens);
        if (k > 0) exchange(Slip::terms_exchanged, terms[k - 1].tokens, terms[k].tokens);
      }
      for (const Piece& piece : level.pieces) added_square(piece);
      factors(level);
    }
    for (std::size_t k = 0; k < side_.size(); ++k) {
      function(side_[k]);
      fraction(k);
      rate(k);
    }
    for (const Letter& letter : letters_in(side_)) {
      prime_and_dot(letter);
      replaced(letter, statement);
    }
    return std::move(edits_);
  }

 private:
  std::string text(Span span) const { return std::string(sources_.text(span)); }

  void add(Slip slip, Span span, std::string replacement) {
    if (sources_.text(span) == replacement) return;
    const bool known = std::ranges::any_of(
        edits_, [&](const Edit& edit) { return edit.span == span && edit.text == replacement; });
    if (!known) edits_.push_back({slip, span, std::move(replacement)});
  }

  /// `\omega m`, not `\omegam`.
  static std::string joined(std::string before, std::string_view text) {
    const std::size_t slash = before.rfind('\\');
    const bool word = slash != std::string::npos && slash + 1 < before.size() &&
                      std::all_of(before.begin() + static_cast<std::ptrdiff_t>(slash) + 1, before.end(),
                                  [](char each) { return is_letter(each); });
    if (word && !text.empty() && is_letter(text.front())) before += ' ';
    return before.append(text);
  }

  void exchange(Slip slip, TokenView first, TokenView second) {
    const Span a = span_of(first);
    const Span b = span_of(second);
    if (a.end > b.begin || text_of(first) == text_of(second)) return;
    const std::string between = text(Span{a.file, a.end, b.begin});
    const std::string behind =
        b.end < span_of(side_).end ? text(Span{b.file, b.end, b.end + 1}) : std::string();
    std::string before;
    for (const Token& token : side_) {
      if (token.span.end == a.begin && token.kind == TokenKind::control) before = text(token.span);
    }
    std::string exchanged = joined(joined(joined(before, text(b)), between), text(a));
    exchanged = joined(std::move(exchanged), behind);
    exchanged.resize(exchanged.size() - behind.size());
    add(slip, cover(a, b), exchanged.substr(before.size()));
  }

  /// Of two factors of one term.
  void indices_between(TokenView term) {
    std::vector<std::pair<std::size_t, const Token*>> indices;
    const std::vector<TokenView> subscripts = subscripts_of(term);
    for (std::size_t k = 0; k < subscripts.size(); ++k) {
      if (std::ranges::any_of(subscripts[k], holds_words)) continue;
      for (const Token& token : subscripts[k]) {
        if (token.kind == TokenKind::letter || token.kind == TokenKind::digit)
          indices.emplace_back(k, &token);
      }
    }
    for (std::size_t a = 0; a < indices.size(); ++a) {
      for (std::size_t b = a + 1; b < indices.size(); ++b) {
        const auto& [of_a, first] = indices[a];
        const auto& [of_b, second] = indices[b];
        if (of_b == of_a + 1 && first->kind == second->kind)
          exchange(Slip::indices_exchanged, TokenView(first, 1), TokenView(second, 1));
      }
    }
  }

  /// Neighbours with one face.
  void letters_within(TokenView term) {
    const std::vector<Letter> letters = letters_in(term);
    for (std::size_t k = 1; k < letters.size(); ++k) {
      if (letters[k].face == letters[k - 1].face)
        exchange(Slip::letters_exchanged, TokenView(letters[k - 1].token, 1), TokenView(letters[k].token, 1));
    }
  }

  void added_square(const Piece& piece) {
    if (piece.kind != PieceKind::factor || letters_in(piece.tokens).empty()) return;
    const bool raised = std::ranges::any_of(piece.tokens, [](const Token& token) {
      return token.kind == TokenKind::superscript || is_control_of(token, {"nabla", "partial", "sum", "int"});
    });
    const Span span = span_of(piece.tokens);
    if (!raised) add(Slip::square_added, Span{span.file, span.end, span.end}, "^2");
  }

  /// A factor that is a letter is left out.
  void factors(const PieceLevel& level) {
    for (std::size_t k = 0; k < level.pieces.size(); ++k) {
      const Piece& piece = level.pieces[k];
      const bool letter = piece.kind == PieceKind::factor && letters_in(piece.tokens).size() == 1 &&
                          std::ranges::none_of(piece.tokens, [](const Token& token) {
                            return is_control_of(token, {"nabla", "partial"}) || is_face(token);
                          });
      const auto is_factor = [&](std::size_t at) {
        return at < level.pieces.size() && (level.pieces[at].kind == PieceKind::factor);
      };
      const bool alone = !(k > 0 && is_factor(k - 1)) && !is_factor(k + 1);
      // The argument of `\cos`, `\hat` or `\partial` is no factor.
      const bool of_control = k > 0 && is_factor(k - 1) && takes_an_argument(level.pieces[k - 1].tokens);
      if (of_control) continue;
      if (letter && !alone) add(Slip::factor_dropped, span_of(piece.tokens), " ");
    }
  }

  void function(const Token& token) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 8> neighbours{{
        {"sin", "cos"},
        {"sinh", "cosh"},
        {"tan", "cot"},
        {"tanh", "coth"},
        {"sin", "sinh"},
        {"cos", "cosh"},
        {"tan", "tanh"},
        {"arcsin", "arccos"},
    }};
    if (token.kind != TokenKind::control) return;
    for (const auto& [one, other] : neighbours) {
      if (token.text == one) add(Slip::function, token.span, fmt::format("\\{}", other));
      if (token.text == other) add(Slip::function, token.span, fmt::format("\\{}", one));
    }
  }

  void fraction(std::size_t k) {
    if (!is_control_of(side_[k], {"frac", "tfrac", "dfrac"})) return;
    const Argument upper = argument_at(side_, k + 1);
    const Argument lower = argument_at(side_, upper.next);
    if (upper.content.empty() || lower.content.empty()) return;
    const auto differentiates = [](TokenView part) {
      return std::ranges::any_of(part, [](const Token& token) {
        return is_control(token, "partial") || (token.kind == TokenKind::letter && token.text == "d");
      });
    };
    if (differentiates(lower.content)) return;
    exchange(Slip::fraction_inverted, upper.content, lower.content);
    const Span below = span_of(lower.content);
    const bool braced =
        lower.content.data() > &side_[0] && is_kind_at(side_, upper.next, TokenKind::begin_group);
    if (braced) add(Slip::denominator, Span{below.file, below.begin, below.begin}, "2");
    if (lower.content.size() > 1 && lower.content[0].kind == TokenKind::digit &&
        lower.content[1].kind != TokenKind::digit)
      add(Slip::denominator, lower.content[0].span, "");
  }

  void rate(std::size_t k) {
    if (!is_rate(side_[k])) return;
    const Argument under = argument_at(side_, k + 1);
    if (under.content.empty()) return;
    const Span all = cover(side_[k].span, side_[under.next - 1].span);
    add(Slip::dot, all, fmt::format("{{{}}}", text(span_of(under.content))));
    add(Slip::dot, side_[k].span, side_[k].text == "dot" ? "\\ddot" : "\\dot");
  }

  void prime_and_dot(const Letter& letter) {
    const std::size_t begin = static_cast<std::size_t>(letter.whole.data() - side_.data());
    const std::size_t next = begin + letter.whole.size();
    const Span span = span_of(letter.whole);
    if (is_sign_at(side_, next, "'")) {
      add(Slip::prime, side_[next].span, " ");
      return;
    }
    const bool dotted = begin > 0 && (is_rate(side_[begin - 1]) || (begin > 1 && is_rate(side_[begin - 2])));
    const bool of_script = begin > 0 && side_[begin - 1].kind == TokenKind::superscript;
    if (dotted || of_script) return;
    add(Slip::prime, Span{span.file, span.end, span.end}, "'");
    add(Slip::dot, span, fmt::format("\\dot{{{}}}", text(span)));
  }

  /// By another letter of the statement with the same face.
  void replaced(const Letter& letter, const std::vector<TokenView>& statement) {
    for (const TokenView side : statement) {
      for (const Letter& other : letters_in(side)) {
        if (other.face != letter.face || is_same(*other.token, *letter.token)) continue;
        const bool control = other.token->kind == TokenKind::control;
        add(Slip::letter_replaced, letter.token->span,
            fmt::format(" {}{}{}", control ? "\\" : "", other.token->text, control ? " " : ""));
      }
    }
  }

  const SourceMap& sources_;
  TokenView side_;
  std::vector<Edit> edits_;
};

}  // namespace

std::vector<Edit> further_slips_of(const SourceMap& sources, TokenView side,
                                   const std::vector<TokenView>& statement) {
  return FurtherMutator(sources, side).edits(statement);
}

}  // namespace rigor::twins
