// SPDX-License-Identifier: GPL-3.0-or-later
#include "elaborate/evidence/evidence.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "base/among.h"
#include "base/ascii.h"
#include "latex/token/tokens.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

/// The letter at `at` with its accent, and the place after it; subscripts and primes are not looked at.
struct LetterAt {
  std::string name;  // empty: no letter
  std::size_t next = 0;
};

LetterAt letter_at(TokenView tokens, std::size_t at) {
  const Token& token = tokens[at];
  const std::string plain = letter_of(token);
  if (!plain.empty()) return {plain, at + 1};
  const auto style = style_of(token);
  if (!style || style->upright) return {{}, at + 1};
  const Argument argument = argument_at(tokens, at + 1);
  const TokenView content = trim(argument.content);
  if (content.empty()) return {{}, at + 1};
  LetterAt inside = letter_at(content, 0);
  if (inside.name.empty() || inside.next != content.size()) return {{}, at + 1};
  // Products of bold letters are dyads, and told apart elsewhere.
  if (style->face != Face::plain) return {{}, argument.next};
  if (style->accent == Accent::hat) inside.name = "\\hat{" + inside.name + "}";
  return {inside.name, argument.next};
}

bool is_subscript_at(TokenView tokens, std::size_t at) {
  at = skip_blank(tokens, at);
  return at < tokens.size() && tokens[at].kind == TokenKind::subscript;
}

struct FoundLetter {
  std::string name;
  bool labelled;  // a subscript is on it
};

std::vector<FoundLetter> letters_in(TokenView tokens) {
  std::vector<FoundLetter> letters;
  for (std::size_t at = 0; at < tokens.size();) {
    if (tokens[at].kind == TokenKind::subscript || tokens[at].kind == TokenKind::superscript) {
      at = script_argument_at(tokens, at + 1).next;
      continue;
    }
    LetterAt letter = letter_at(tokens, at);
    if (!letter.name.empty())
      letters.push_back({std::move(letter.name), is_subscript_at(tokens, letter.next)});
    at = letter.next;
  }
  return letters;
}

void add_letter(const std::string& letter, bool labelled, Evidence& evidence) {
  evidence.ordered.insert(letter);
  if (labelled) evidence.labelled.insert(letter);
}

void add_letters(TokenView tokens, Evidence& evidence) {
  for (const FoundLetter& letter : letters_in(tokens)) add_letter(letter.name, letter.labelled, evidence);
}

std::size_t behind_subscript(TokenView tokens, std::size_t at) {
  at = skip_blank(tokens, at);
  if (at >= tokens.size() || tokens[at].kind != TokenKind::subscript) return at;
  return skip_blank(tokens, script_argument_at(tokens, at + 1).next);
}

/// Is there a dagger or a transpose at `at`?
enum class Adjoint : std::uint8_t { none, transpose, dagger };

Adjoint adjoint_at(TokenView tokens, std::size_t at) {
  if (at >= tokens.size() || tokens[at].kind != TokenKind::superscript) return Adjoint::none;
  const Argument argument = script_argument_at(tokens, at + 1);
  const std::string text = text_of(argument.content);
  for (const char* mark : {"\\dagger", "\\dag", "†"}) {
    if (text == mark) return Adjoint::dagger;
  }
  static constexpr std::array transposes{"T",           "\\top",       "\\intercal",
                                         "\\mathsf{T}", "\\mathrm{T}", "\\mathsf T",
                                         "\\mathrm T",  "\\text{T}",   "\\mathsf {T}"};
  const bool transpose = is_one_of(text, transposes);
  return transpose ? Adjoint::transpose : Adjoint::none;
}

bool opens(const Token& token) {
  Nesting alone(false);
  static_cast<void>(alone.enter(token));
  return alone.enter(Token{}) > 0;
}

/// For each opening bracket the place of the one that closes it; for the others, and where none does, the
/// size.
std::vector<std::size_t> closing_brackets(TokenView tokens) {
  std::vector<std::size_t> closing(tokens.size(), tokens.size());
  std::vector<std::size_t> open;
  Nesting nesting(false);
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    const auto depth = static_cast<std::size_t>(nesting.enter(tokens[at]));
    if (depth < open.size()) {
      closing[open.back()] = at;
      open.pop_back();
    } else if (opens(tokens[at])) {
      open.push_back(at);
    }
  }
  return closing;
}

/// `[x, p]`: what is in it, unless it is an interval or has limits.
TokenView commutator_at(TokenView tokens, std::size_t at, std::size_t end) {
  constexpr std::size_t longest = 500;  // tokens
  if (end >= tokens.size() || end - at > longest || !is_sign(tokens[end], "]")) return {};
  const std::size_t behind = skip_blank(tokens, end + 1);
  const bool scripts = behind < tokens.size() && tokens[behind].kind == TokenKind::superscript;
  const TokenView content = tokens.subspan(at + 1, end - at - 1);
  Nesting nesting(false);
  std::size_t commas = 0;
  std::size_t comma = 0;
  for (std::size_t k = 0; k < content.size(); ++k) {
    if (nesting.enter(content[k]) != 0 || !is_sign(content[k], ",")) continue;
    ++commas;
    comma = k;
  }
  if (commas != 1 || scripts) return {};
  const bool both =
      !letters_in(content.first(comma)).empty() && !letters_in(content.subspan(comma + 1)).empty();
  return both ? content : TokenView{};
}

bool is_trace(TokenView tokens, std::size_t at) {
  const std::string_view word = tokens[at].text;
  if (tokens[at].kind != TokenKind::control) return false;
  if (word == "operatorname" || word == "mathrm") {
    const std::string name = text_of(argument_at(tokens, at + 1).content);
    return function_name(name) == "tr" || function_name(name) == "det";
  }
  return function_name(word) == "tr" || function_name(word) == "det";
}

void see_ket(TokenView tokens, std::size_t bar, Evidence& evidence) {
  const auto is_angle = [](const Token& token) { return is_control(token, "rangle") || is_sign(token, ">"); };
  const auto first = tokens.begin() + static_cast<std::ptrdiff_t>(bar);
  if (std::find_if(first, tokens.end(), is_angle) == tokens.end()) return;
  evidence.operators = true;
  std::size_t begin = bar;
  while (begin > 0 && (is_blank(tokens[begin - 1]) || is_spacing(tokens[begin - 1]))) --begin;
  if (begin > 0) add_letters(tokens.subspan(begin - 1, 1), evidence);
}

bool is_inverse_at(TokenView tokens, std::size_t at) {
  return at < tokens.size() && tokens[at].kind == TokenKind::superscript &&
         text_of(script_argument_at(tokens, at + 1).content) == "-1";
}

/// `P^{-1}AP`, `(AB)^{-1}`: nobody writes numbers so.
void see_inverses(TokenView tokens, const std::vector<std::size_t>& closing, Evidence& evidence) {
  std::vector<std::pair<std::string, bool>> row;  // letters side by side, inverted?
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    const LetterAt letter = letter_at(tokens, at);
    if (!letter.name.empty()) {
      const std::size_t script = behind_subscript(tokens, letter.next);
      const bool inverted = is_inverse_at(tokens, script);
      row.emplace_back(letter.name, inverted);
      if (inverted) at = script_argument_at(tokens, script + 1).next - 1;
      const std::size_t last = row.size() - 1;
      const bool sandwich = last >= 2 && row[last - 2].first == row[last].first &&
                            is_capital_letter(row[last].first) && is_capital_letter(row[last - 1].first) &&
                            (row[last].second != row[last - 2].second);
      if (sandwich) evidence.ordered.insert({row[last].first, row[last - 1].first});
    }
    if (is_sign(tokens[at], "+") || is_sign(tokens[at], "-")) row.clear();
    if (!is_sign(tokens[at], "(")) continue;
    const std::size_t end = closing[at];
    if (end >= tokens.size() || !is_inverse_at(tokens, skip_blank(tokens, end + 1))) continue;
    const TokenView inside = tokens.subspan(at + 1, end - at - 1);
    const std::vector<FoundLetter> letters = letters_in(inside);
    if (letters.size() > 1 &&
        std::ranges::all_of(letters, [](const FoundLetter& each) { return is_capital_letter(each.name); }))
      add_letters(inside, evidence);
  }
}

void see_tokens(TokenView tokens, bool may_be_interval, Evidence& evidence) {
  const std::vector<std::size_t> closing = closing_brackets(tokens);
  see_inverses(tokens, closing, evidence);
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    const Token& token = tokens[at];
    const LetterAt letter = letter_at(tokens, at);
    if (!letter.name.empty()) {
      const Adjoint adjoint = adjoint_at(tokens, behind_subscript(tokens, letter.next));
      if (adjoint != Adjoint::none) add_letter(letter.name, is_subscript_at(tokens, letter.next), evidence);
      evidence.operators = evidence.operators || adjoint == Adjoint::dagger || letter.name == "\\hat{p}" ||
                           letter.name == "\\hat{H}";
      if (letter.name.starts_with("\\hat{")) evidence.hatted.insert(letter.name);
    }
    const bool opens = is_sign(token, "(") || is_sign(token, "[");
    if (opens) {
      const std::size_t end = closing[at];
      const Adjoint adjoint =
          end < tokens.size() ? adjoint_at(tokens, skip_blank(tokens, end + 1)) : Adjoint::none;
      if (adjoint != Adjoint::none) add_letters(tokens.subspan(at + 1, end - at - 1), evidence);
      evidence.operators = evidence.operators || adjoint == Adjoint::dagger;
    }
    if (is_sign(token, "[") && !may_be_interval) {
      const TokenView inside = commutator_at(tokens, at, closing[at]);
      evidence.operators = evidence.operators || !inside.empty();
      add_letters(inside, evidence);
    }
    for (const char* name : {"comm", "commutator", "acomm", "anticommutator"}) {
      if (!is_control(token, name)) continue;
      const Argument first = argument_at(tokens, at + 1);
      add_letters(first.content, evidence);
      add_letters(argument_at(tokens, first.next).content, evidence);
      evidence.operators = true;
    }
    if (is_trace(tokens, at)) {
      evidence.speaks_of_order = true;  // who writes \det M can mean a matrix by N
      const bool named = token.text == "operatorname" || token.text == "mathrm";
      const std::size_t next = skip_blank(tokens, named ? argument_at(tokens, at + 1).next : at + 1);
      const bool bracket = next < tokens.size() && (is_sign(tokens[next], "(") || is_sign(tokens[next], "["));
      const std::size_t end = bracket ? closing[next] : std::min(next + 1, tokens.size());
      if (next < tokens.size()) add_letters(tokens.subspan(next, end - next), evidence);
    }
    if (is_sign(token, "|") || is_control(token, "vert")) see_ket(tokens, at, evidence);
    if (is_state_bracket(token)) evidence.operators = true;
    if (is_control(token, "otimes") && at > 0 && at + 1 < tokens.size()) {
      add_letters(tokens.subspan(at - 1, 1), evidence);
      add_letters(tokens.subspan(at + 1, 1), evidence);
    }
  }
}

bool holds_a_matrix(const SyntaxTree& syntax, SyntaxId root) {
  return std::ranges::any_of(nodes_below(syntax, {root}),
                             [&](SyntaxId id) { return syntax[id].kind == SyntaxKind::matrix; });
}

// -- words --

/// Is one of the words that speak of matrices or operators at `at`? Its length, else 0.
std::size_t speaks_of_order(std::string_view text, std::size_t at) {
  static constexpr std::array<std::string_view, 33> words{
      "change of basis", "time evolution", "noncommuting", "quaternions", "lie algebra", "projectors",
      "commutator",      "linear map",     "quaternion",   "generators",  "anticommut",  "heisenberg",
      "similarity",      "operators",      "projector",    "commuting",   "hermitian",   "transpose",
      "rotations",       "grassmann",      "lie group",    "matrices",    "operator",    "clifford",
      "fermions",        "commute",        "unitary",      "fermion",     "matrix",      "spinor",
      "gates",           "pauli",          "dirac"};
  const bool begins = at == 0 || !is_letter(text[at - 1]);
  if (!begins) return 0;
  for (const std::string_view word : words) {
    if (text.size() - at < word.size()) continue;
    const bool same = std::equal(word.begin(), word.end(), text.begin() + static_cast<std::ptrdiff_t>(at),
                                 [](char a, char b) { return a == lowered(b); });
    if (same) return word.size();
  }
  return 0;
}

/// The letters of `$A$`, `$\sigma_x$`: capitals of the sentence, and small and Greek ones that directly
/// follow the word.
void see_inline(std::string_view formula, bool follows, Evidence& evidence) {
  for (std::size_t at = 0; at < formula.size(); ++at) {
    const char c = formula[at];
    if (c == '\\') {
      std::size_t end = at + 1;
      while (end < formula.size() && is_letter(formula[end])) ++end;
      const std::string word(formula.substr(at, end - at));
      const bool labelled = end < formula.size() && formula[end] == '_';
      if (is_greek(word) && follows) add_letter(word, labelled, evidence);
      at = end - 1;
      const bool bold = word == "\\mathbf" || word == "\\vec" || word == "\\boldsymbol" || word == "\\bm";
      if (bold) at = std::min(formula.find_first_of("} ", end + 1), formula.size());
      continue;
    }
    const bool capital = is_capital_letter(c);
    const bool small = c >= 'a' && c <= 'z';
    if (c == '_' || c == '^') return;  // a script says nothing of its own
    const bool labelled = at + 1 < formula.size() && formula[at + 1] == '_';
    if (capital || (small && follows)) add_letter(std::string(1, c), labelled, evidence);
  }
}

}  // namespace

void see_order(const SyntaxTree& syntax, const std::vector<SyntaxId>& sides, const WrittenChain& written,
               Evidence& evidence) {
  bool member = false;
  for (const WrittenRelation& relation : written.relations) {
    member = member || relation.kind == RelationKind::other;
  }
  for (const WrittenSide& side : written.sides) see_tokens(side.tokens, member, evidence);
  const bool matrix = std::ranges::any_of(sides, [&](SyntaxId side) { return holds_a_matrix(syntax, side); });
  for (const SyntaxId side : sides) {
    const bool alone = syntax[side].kind == SyntaxKind::symbol && syntax.symbol(side).face == Face::plain;
    if (!matrix || !alone) continue;
    add_letter(letter_with_marks(syntax.symbol(side)), !syntax.symbol(side).lower.empty(), evidence);
  }
  if (!evidence.sentence_is_open) return;
  // "The Pauli matrices are" and then a display: its letters are what the sentence speaks of.
  evidence.sentence_is_open = false;
  for (std::size_t k = 0; k < sides.size() && k < written.sides.size(); ++k) {
    const SyntaxKind kind = syntax[sides[k]].kind;
    if (kind == SyntaxKind::symbol || kind == SyntaxKind::tuple)
      add_letters(written.sides[k].tokens, evidence);
  }
}

void see_words(std::string_view text, Evidence& evidence) {
  evidence.sentence_is_open = false;
  std::size_t sentence = 0;
  bool speaks = false;
  std::size_t word_end = 0;
  const auto end_sentence = [&](std::size_t end) {
    if (!speaks) return;
    evidence.speaks_of_order = true;
    bool inside = false;
    std::size_t begin = 0;
    for (std::size_t at = sentence; at < end; ++at) {
      if (text[at] != '$') continue;
      if (!inside) begin = at + 1;
      if (inside) {
        const std::string_view between =
            word_end != 0 && word_end < begin ? text.substr(word_end, begin - 1 - word_end) : "..........";
        const bool follows = between.size() < 8 && between.find('.') == std::string_view::npos;
        see_inline(text.substr(begin, at - begin), follows, evidence);
        if (follows) word_end = at + 1;  // "$x$ and $p$"
      }
      inside = !inside;
    }
  };
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool stop = text[at] == '.' && (at + 1 >= text.size() || is_white(text[at + 1]));
    const bool blank_line = text[at] == '\n' && at + 1 < text.size() && text[at + 1] == '\n' &&
                            text.find_first_not_of(" \n\t", at) != std::string_view::npos;
    if (stop || blank_line) {
      end_sentence(at);
      sentence = at + 1;
      speaks = false;
      word_end = 0;
      continue;
    }
    const std::size_t length = speaks_of_order(text, at);
    if (length == 0) continue;
    if (!speaks) word_end = at + length;
    speaks = true;
  }
  end_sentence(text.size());
  evidence.sentence_is_open = speaks;
}

void see_heading(std::string_view title, Evidence& evidence) {
  static constexpr std::array<std::string_view, 11> words{"heisenberg", "commut",   "operator",  "quantiz",
                                                          "quantis",    "clifford", "grassmann", "quaterni",
                                                          "fermi",      "pauli",    "dirac"};
  const std::string lower = lowered(title);
  const bool speaks = std::ranges::any_of(
      words, [&](std::string_view word) { return lower.find(word) != std::string::npos; });
  evidence.order_in_heading = evidence.order_in_heading || speaks;
}

void settle_order(Evidence& evidence) {
  for (const std::string& number : evidence.multiples) evidence.ordered.erase(number);
  if (evidence.operators) evidence.ordered.insert(evidence.hatted.begin(), evidence.hatted.end());
}

}  // namespace rigor
