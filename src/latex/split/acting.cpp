// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/split/acting.h"

#include <algorithm>

#include "base/ascii.h"
#include "latex/token/differential.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

/// The letters of a word without blanks around it; empty for anything else.
std::string word_of(TokenView tokens) {
  std::string word;
  for (const Token& token : trim(tokens)) {
    if (token.kind != TokenKind::letter || token.text.size() != 1) return {};
    word += token.text;
  }
  return word;
}

bool is_upright_word(const Token& token) {
  const auto style = style_of(token);
  return (style && style->upright) ||
         (is_words(token) && token.text != "textbf" && token.text != "textit" && token.text != "emph");
}

/// `\rm` with the rest of its group, `\mathrm{…}`, `\operatorname*{…}`.
std::optional<UprightWord> styled_word(TokenView tokens, std::size_t at) {
  if (at >= tokens.size() || !is_upright_word(tokens[at])) return std::nullopt;
  if (is_control(tokens[at], "rm")) return UprightWord{word_of(tokens.subspan(at + 1)), tokens.size()};
  const bool star = at + 1 < tokens.size() && is_sign(tokens[at + 1], "*");
  const Argument argument = argument_at(tokens, at + (star ? 2 : 1));
  const std::string word = word_of(argument.content);
  if (!word.empty()) return UprightWord{word, argument.next};
  const TokenView inside = trim(argument.content);  // \text{\rm grad}
  auto nested = styled_word(inside, 0);
  if (!nested || nested->next != inside.size()) return std::nullopt;
  return UprightWord{nested->word, argument.next};
}

/// `D`, `\mathrm D`, `\mathrm{D}^2`: the place after it; `at` itself for anything else.
std::size_t behind_material(TokenView tokens, std::size_t at) {
  at = skip_narrow(tokens, at);
  if (at >= tokens.size()) return at;
  std::size_t end = at;
  if (is_letter(tokens[at], "D")) {
    end = at + 1;
  } else if (const auto word = styled_word(tokens, at); word && word->word == "D") {
    end = word->next;
  }
  const std::size_t script = skip_blank(tokens, end);
  if (end != at && is_kind_at(tokens, script, TokenKind::superscript))
    end = script_argument_at(tokens, script + 1).next;
  return end;
}

}  // namespace

std::optional<UprightWord> upright_word_at(TokenView tokens, std::size_t at) {
  if (at >= tokens.size()) return std::nullopt;
  const bool group = tokens[at].kind == TokenKind::begin_group;
  if (!group && !is_control(tokens[at], "mathop")) {
    auto word = styled_word(tokens, at);
    return word && word->word.size() > 1 ? word : std::nullopt;
  }
  const Argument argument = argument_at(tokens, group ? at : at + 1);
  const TokenView inside = trim(argument.content);
  const auto word = styled_word(inside, 0);
  if (!word || word->next != inside.size() || word->word.size() < 2) return std::nullopt;
  return UprightWord{word->word, argument.next};
}

std::optional<TokenView> mathematics_in(TokenView words) {
  words = trim(words);
  if (words.size() < 3 || !is_sign(words.front(), "$") || !is_sign(words.back(), "$")) return std::nullopt;
  words = words.subspan(1, words.size() - 2);
  if (std::ranges::any_of(words, [](const Token& token) { return is_sign(token, "$"); })) return std::nullopt;
  return words;
}

bool writes_mathematics(TokenView tokens, std::size_t at) {
  if (const auto word = upright_word_at(tokens, at))
    return !function_name(word->word).empty() || field_operator(word->word) || word->word == "rot";
  if (!is_words(tokens[at])) return false;
  const TokenView words = argument_at(tokens, at + 1).content;
  return trim(words).size() == 1 || mathematics_in(words);
}

std::size_t landau_end(TokenView tokens, std::size_t at) {
  if (at >= tokens.size()) return at;
  if (is_control_of(tokens[at], {"order", "bigO", "BigO"})) {
    const std::size_t open = skip_narrow(tokens, at + 1);
    if (is_kind_at(tokens, open, TokenKind::begin_group)) return argument_at(tokens, open).next;
    return bracket_end(tokens, open) == open ? at : bracket_end(tokens, open);
  }
  const auto is_symbol = [](const Token& token) { return is_letter(token, "O") || is_letter(token, "o"); };
  std::size_t next = at;
  if (is_symbol(tokens[at])) {
    next = at + 1;
  } else if (style_of(tokens[at]) || is_words(tokens[at])) {
    const Argument argument = argument_at(tokens, at + 1);
    const TokenView letter = trim(argument.content);
    if (letter.size() == 1 && is_symbol(letter[0])) next = argument.next;
  } else if (tokens[at].kind == TokenKind::begin_group) {  // {\cal O}(x)
    const Argument group = argument_at(tokens, at);
    const TokenView inside = trim(group.content);
    if (!inside.empty() && is_symbol(inside.back()) && inside.size() < 4) next = group.next;
  }
  if (next == at) return at;
  const std::size_t open = skip_narrow(tokens, next);
  if (!is_sign_at(tokens, open, "(")) return at;
  const std::size_t end = bracket_end(tokens, open);
  return end == open ? at : end;
}

std::optional<TokenView> landau_argument(TokenView tokens, std::size_t at, std::size_t end) {
  const TokenView written = tokens.subspan(at, end - at);
  const bool small = std::ranges::any_of(written, [](const Token& each) { return is_letter(each, "o"); });
  if (small || written.empty()) return std::nullopt;
  if (written.back().kind == TokenKind::end_group) {  // \order{x}
    const std::size_t open = skip_narrow(written, 1);
    if (!is_kind_at(written, open, TokenKind::begin_group)) return std::nullopt;
    return argument_at(written, open).content;
  }
  for (std::size_t open = 0; open + 1 < written.size(); ++open) {
    if (is_sign(written[open], "(")) return written.subspan(open + 1, written.size() - open - 2);
  }
  return std::nullopt;
}

bool is_material(TokenView above, TokenView below) {
  const std::size_t top = behind_material(above, 0);
  const std::size_t bottom = behind_material(below, 0);
  if (top == skip_narrow(above, 0) || bottom == skip_narrow(below, 0)) return false;
  const std::size_t operand = skip_narrow(above, top);
  if (operand < above.size()) {
    const Token& token = above[operand];
    const bool sign = is_sign_of(token, "+-") || factor_joint(token) != Joint::none;
    if (sign || token.kind == TokenKind::subscript || is_sign(token, "'")) return false;
  }
  const std::size_t variable = skip_narrow(below, bottom);
  const std::size_t end = symbol_end(below, variable);
  return end != variable && skip_narrow(below, end) == below.size();
}

std::optional<TokenView> material_operand(TokenView above, TokenView below) {
  if (!is_material(above, below)) return std::nullopt;
  const auto has_power = [](TokenView tokens) {
    const std::size_t end = behind_material(tokens, 0);
    return std::any_of(tokens.begin(), tokens.begin() + static_cast<std::ptrdiff_t>(end),
                       [](const Token& each) { return each.kind == TokenKind::superscript; });
  };
  const TokenView variable = trim(below.subspan(behind_material(below, 0)));
  const std::size_t first = skip_narrow(variable, 0);
  const bool by_time = first + 1 == variable.size() && is_letter(variable[first], "t");
  if (has_power(above) || has_power(below) || !by_time) return std::nullopt;
  return above.subspan(skip_narrow(above, behind_material(above, 0)));
}

std::size_t material_end(TokenView tokens, std::size_t at) {
  const std::size_t top = behind_material(tokens, at);
  if (top == skip_narrow(tokens, at)) return at;
  const std::size_t begin = skip_narrow(tokens, top);
  std::size_t end = symbol_end(tokens, begin);
  if (end == begin) end = bracket_end(tokens, begin);
  const std::size_t slash = skip_narrow(tokens, end);
  if (!is_sign_at(tokens, slash, "/")) return at;
  const std::size_t below = skip_narrow(tokens, slash + 1);
  const std::size_t bottom = behind_material(tokens, below);
  if (bottom == below) return at;
  const std::size_t variable = skip_narrow(tokens, bottom);
  const std::size_t behind = symbol_end(tokens, variable);
  return behind == variable ? at : behind;
}

bool is_lone_differential(TokenView tokens, std::size_t at) {
  const Token& token = tokens[at];
  const auto style = style_of(token);
  const bool upright = (style && style->upright) || is_words(token) || is_control(token, "dd") ||
                       is_control(token, "differential");
  const auto mark = upright ? differential_at(tokens, at) : std::nullopt;
  if (!mark) return false;
  const std::size_t next = skip_narrow(tokens, mark->next);
  if (next >= tokens.size()) return false;
  return symbol_end(tokens, next) != next || bracket_end(tokens, next) != next ||
         tokens[next].kind == TokenKind::begin_group;
}

}  // namespace rigor
