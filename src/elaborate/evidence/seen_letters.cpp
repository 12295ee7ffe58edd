// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/evidence/evidence.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "base/ascii.h"
#include "expr/print/usual_letters.h"
#include "latex/token/tokens.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

bool is_star(TokenView script) {
  const std::string text = text_of(script);
  return text == "*" || text == "\\ast" || text == "\\star";
}

/// `[X]`, and not `[A, B]`, nor `[b + (c + d)]`, which only nests.
bool is_applied(TokenView content) {
  return !content.empty() && std::ranges::none_of(content, [](const Token& token) {
    return is_sign(token, ",") || is_sign(token, "(") || is_sign(token, ";");
  });
}

/// `E[X]`, `S[\rho]`, `E\{X\}`: after a letter that is no usual coefficient.
void see_functional(TokenView tokens, std::size_t at, Evidence& evidence) {
  std::string letter = letter_of(tokens[at]);
  std::size_t next = at + 1;
  if (const auto style = style_of(tokens[at]); letter.empty() && style && style->face == Face::plain) {
    const Argument argument = argument_at(tokens, at + 1);
    const TokenView inside = trim(argument.content);
    if (inside.size() == 1) letter = letter_of(inside[0]);
    if (letter.empty()) return;
    if (!style->alphabet.empty()) letter = fmt::format("\\{}{{{}}}", style->alphabet, letter);
    if (style->upright) letter = fmt::format("\\mathrm{{{}}}", letter);
    next = argument.next;
  }
  const bool capital = is_capital_letter(letter);
  const bool greek_capital = is_greek(letter) && letter.size() > 1 && is_capital_letter(letter[1]);
  const bool function = letter == "f" || letter == "g" || letter == "h";
  const bool styled = letter.starts_with("\\math");
  if (!function && !styled && !greek_capital && (!capital || is_usual_coefficient(letter))) return;
  if (next >= tokens.size()) return;
  const bool brace = is_control(tokens[next], "{") || is_control(tokens[next], "lbrace");
  if (!brace && !is_sign(tokens[next], "[")) return;
  Nesting nesting(false);
  for (std::size_t end = next; end < tokens.size(); ++end) {
    const bool closes = brace ? is_control(tokens[end], "}") || is_control(tokens[end], "rbrace")
                              : nesting.enter(tokens[end]) == 0 && end != next;
    if (!closes) continue;
    if (is_applied(tokens.subspan(next + 1, end - next - 1))) evidence.functionals.insert(letter);
    return;
  }
}

/// `\psi^*`, `\psi_n^*`.
void see_conjugate(TokenView tokens, std::size_t at, Evidence& evidence) {
  const std::string letter = letter_of(tokens[at]);
  if (letter.empty()) return;
  std::size_t next = skip_blank(tokens, at + 1);
  if (next < tokens.size() && tokens[next].kind == TokenKind::subscript)
    next = skip_blank(tokens, script_argument_at(tokens, next + 1).next);
  const bool above = next < tokens.size() && tokens[next].kind == TokenKind::superscript;
  if (above && is_star(script_argument_at(tokens, next + 1).content)) evidence.complex.insert(letter);
}

bool is_plain_symbol(const SyntaxTree& syntax, SyntaxId id) {
  return syntax[id].kind == SyntaxKind::symbol && syntax.symbol(id).face == Face::plain;
}

/// A number with its sign, but for 0 and 1, which are also written for matrices.
bool is_value(const SyntaxTree& syntax, SyntaxId id) {
  return syntax[id].kind == SyntaxKind::number && syntax.text(id) != "0" && syntax.text(id) != "1";
}

// -- words --

using Words = std::span<const std::string_view>;

/// Does a word of the text begin with one of these?
bool speaks_of(std::string_view lower, Words words) {
  return std::ranges::any_of(words, [&](std::string_view word) {
    for (std::size_t at = lower.find(word); at != std::string_view::npos; at = lower.find(word, at + 1)) {
      if (at == 0 || !is_letter(lower[at - 1])) return true;
    }
    return false;
  });
}

constexpr std::array<std::string_view, 16> complex_words{
    "complex", "wave function", "wavefunction",  "phasor",        "impedance", "quantum",
    "schr",    "holomorphic",   "analytic",      "conjugat",      "argand",    "spinor",
    "qubit",   "modulus one",   "root of unity", "roots of unity"};
/// Then fields and amplitudes are complex vectors as well.
constexpr std::array<std::string_view, 2> complex_vector_words{"complex", "jones vector"};
/// In formulas of a line.
constexpr std::array<std::string_view, 10> imaginary_signs{
    "\\mathbb{C}", "\\mathbb C", "\\in\\C", "\\mathbf C", "e^{i",
    "e^{-i",       "e^{\\pm",    "+iy",     "+ iy",       "\\mathrm{i}"};
constexpr std::array<std::string_view, 9> segment_words{"triangle",   "segment",    "parallelogram",
                                                        "polygon",    "chord",      "quadrilateral",
                                                        "the line $", "the side $", "hypotenuse"};
constexpr std::array<std::string_view, 7> number_words{"number",  "scalar",   "constant",   "real",
                                                       "integer", "positive", "coefficient"};
constexpr std::array<std::string_view, 13> plural_words{
    "two numbers",      "three numbers", "any numbers",      "all numbers", "real numbers",
    "rational numbers", "whole numbers", "positive numbers", "are numbers", "scalars",
    "constants",        "coefficients",  "amplitudes"};
constexpr std::array<std::string_view, 4> denying_words{"not ", "no ", "nobody", "structure constants"};
constexpr std::array<std::string_view, 3> real_words{"real", "integer", "positive"};
constexpr std::array<std::string_view, 8> other_words{"matri",     "operator", "vector",    "tensor",
                                                      "generator", "complex",  "real part", "constant of"};

/// The letters of `a`, `a, b`, `a, b > 0`, `x \in \mathbb R`; `ordered`: what comes after says that they
/// are real. Nothing for any other formula.
struct ListedLetters {
  std::vector<std::string> letters;
  bool ordered = false;
};

ListedLetters listed_letters(std::string_view formula) {
  ListedLetters found;
  for (std::size_t at = 0; at < formula.size(); ++at) {
    const char c = formula[at];
    if (c == ' ' || c == ',' || c == '~') continue;
    if (c == '>' || c == '<') {
      found.ordered = true;
      return found;
    }
    if (c == '\\') {
      std::size_t end = at + 1;
      while (end < formula.size() && is_letter(formula[end])) ++end;
      const std::string word(formula.substr(at, end - at));
      const bool order = word == "\\ge" || word == "\\geq" || word == "\\le" || word == "\\leq";
      const std::string_view rest = formula.substr(end);
      const bool member =
          word == "\\in" &&
          (rest.find("{R}") != std::string_view::npos || rest.find("bb R") != std::string_view::npos ||
           rest.find("bf R") != std::string_view::npos || rest.find("\\R") != std::string_view::npos);
      found.ordered = order || member;
      if (found.ordered) return found;
      if (!is_greek(word)) return {};
      found.letters.push_back(word);
      at = end - 1;
      continue;
    }
    if (c == '_') {  // its subscript says nothing of its own
      at += 1;
      if (at < formula.size() && formula[at] == '{') at = std::min(formula.find('}', at), formula.size());
      continue;
    }
    if (!is_letter(c)) return {};
    const bool alone = found.letters.empty() || formula[at - 1] == ',' || formula[at - 1] == ' ';
    if (!alone) return {};
    found.letters.emplace_back(1, c);
  }
  return found;
}

/// `$AB$`, "the triangle ABC": capitals in a row.
void see_points(std::string_view text, Evidence& evidence) {
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && is_capital_letter(text[end])) ++end;
    const bool apart = (at == 0 || !is_letter(text[at - 1])) && (end == text.size() || !is_letter(text[end]));
    const bool name = apart && end - at >= 2 && end - at <= 4;
    for (std::size_t k = at; name && k < end; ++k) evidence.points.insert(std::string(1, text[k]));
    at = std::max(end, at + 1);
  }
}

void see_sentence(std::string_view sentence, Evidence& evidence) {
  const std::string lower = lowered(sentence);
  const bool other = speaks_of(lower, other_words);
  const bool number = !other && speaks_of(lower, number_words);
  const bool real = !other && speaks_of(lower, real_words);
  std::size_t open = sentence.find('$');
  if (open == std::string_view::npos && !other && speaks_of(lower, plural_words) &&
      !speaks_of(lower, denying_words))
    evidence.speaks_of_numbers = true;
  while (open != std::string_view::npos) {
    const std::size_t close = sentence.find('$', open + 1);
    if (close == std::string_view::npos) return;
    const ListedLetters listed = listed_letters(sentence.substr(open + 1, close - open - 1));
    const bool of_it =
        sentence.substr(0, open).ends_with(" of ");  // "a number $\lambda$ is an eigenvalue of $A$"
    for (const std::string& letter : listed.letters) {
      if (listed.ordered || number) evidence.numbers.insert(letter);
      if (listed.ordered || (number && !of_it)) evidence.plain_numbers.insert(letter);
      if (listed.ordered || real) evidence.real.insert(letter);
    }
    open = sentence.find('$', close + 1);
  }
}

}  // namespace

void see_letters(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, const WrittenChain& written,
                 Evidence& evidence) {
  for (const WrittenSide& side : written.sides) {
    for (std::size_t at = 0; at < side.tokens.size(); ++at) {
      see_functional(side.tokens, at, evidence);
      see_conjugate(side.tokens, at, evidence);
    }
  }
  for (std::size_t k = 0; k + 1 < sides.size() && k < written.relations.size(); ++k) {
    const RelationKind kind = written.relations[k].kind;
    const bool order = kind == RelationKind::less || kind == RelationKind::less_or_equal ||
                       kind == RelationKind::greater || kind == RelationKind::greater_or_equal;
    for (const auto& [one, other] : {std::pair(sides[k], sides[k + 1]), std::pair(sides[k + 1], sides[k])}) {
      if (!is_plain_symbol(syntax, one) || (!order && !is_value(syntax, other))) continue;
      evidence.real.insert(letter_with_marks(syntax.symbol(one)));
      if (!order) evidence.numbers.insert(letter_with_marks(syntax.symbol(one)));
    }
  }
}

void see_said(std::string_view text, Evidence& evidence) {
  const std::string lower = lowered(text);
  const bool imaginary = std::ranges::any_of(
      imaginary_signs, [&](std::string_view sign) { return text.find(sign) != std::string_view::npos; });
  evidence.speaks_of_complex |= imaginary || speaks_of(lower, complex_words);
  evidence.complex_vectors |= imaginary || speaks_of(lower, complex_vector_words);
  if (speaks_of(lower, segment_words)) {
    evidence.speaks_of_segments = true;
    see_points(text, evidence);
  }
  std::size_t begin = 0;
  while (begin < text.size()) {
    std::size_t end = text.find(". ", begin);
    end = std::min({end, text.find(".\n", begin), text.find("\n\n", begin), text.size()});
    see_sentence(text.substr(begin, end - begin), evidence);
    begin = end + 2;
  }
}

}  // namespace rigor
