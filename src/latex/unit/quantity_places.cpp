// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/unit/quantity_places.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include "latex/token/cover_tokens.h"
#include "latex/token/differential.h"
#include "latex/token/vocabulary.h"
#include "latex/unit/quantity_names.h"

namespace rigor {
namespace {

/// The letters from the first to the last as one text; nothing where they do not stand in a row in one text.
std::optional<std::string_view> written_in_a_row(TokenView content) {
  const char* begin = content.front().text.data();
  const char* end = begin;
  for (std::size_t at = 0; at < content.size(); ++at) {
    if (is_blank(content[at])) {
      if (at > 0 && is_blank(content[at - 1])) return std::nullopt;
      ++end;
      continue;
    }
    if (content[at].text.data() != end) return std::nullopt;
    end += content[at].text.size();
  }
  return std::string_view(begin, static_cast<std::size_t>(end - begin));
}

bool is_written_with_words(const Token& token) {
  return is_control_of(token, {"text", "textrm", "textnormal", "textit", "mbox", "hbox", "mathrm", "mathup",
                               "mathit", "mathnormal", "operatorname"});
}

/// `\text{KE}`, `{\rm KE}`: the words and the place after them.
std::optional<PlacedWord> word_at(TokenView tokens, std::size_t at) {
  std::size_t next = at;
  TokenView content;
  if (is_written_with_words(tokens[at])) {
    const std::size_t star = is_sign_at(tokens, at + 1, "*") ? 1 : 0;
    const std::size_t open = skip_blank(tokens, at + 1 + star);
    if (!is_kind_at(tokens, open, TokenKind::begin_group)) return std::nullopt;
    const Argument argument = argument_at(tokens, open);
    content = argument.content;
    next = argument.next;
  } else if (tokens[at].kind == TokenKind::begin_group && at + 1 < tokens.size() &&
             is_control_of(tokens[at + 1], {"rm", "it"})) {
    const Argument group = argument_at(tokens, at);
    content = group.content.subspan(1);
    next = group.next;
  }
  content = trim(content);
  if (content.size() < 2 || content.front().kind != TokenKind::letter) return std::nullopt;
  PlacedWord word;
  const auto script = std::ranges::find(content, TokenKind::subscript, &Token::kind);
  word.inner = {script, content.end()};
  content = {content.begin(), script};
  if (!word.inner.empty() && script_argument_at(word.inner, 1).next != word.inner.size()) return std::nullopt;
  const auto written = written_in_a_row(content);
  if (!written || !can_name_quantity(*written)) return std::nullopt;
  word.tokens = tokens.subspan(at, next - at);
  word.letter = {TokenKind::letter, *written, span_of(word.tokens)};
  return word;
}

bool is_visible_tie(const Token& token) { return is_sign(token, "~") || is_control(token, " "); }

bool is_skipped(const Token& token) {
  return !is_visible_tie(token) && !is_wide_space(token) &&
         (is_blank(token) || is_spacing(token) || is_bracket_size(token));
}

/// Columns, lines and wide spaces: beside a sign or a relation they mean nothing.
bool is_gap(const Token& token) {
  return token.kind == TokenKind::align || is_wide_space(token) || is_control_of(token, {"\\", "cr"});
}

std::optional<Neighbour> sign_at(TokenView tokens, std::size_t at) {
  const Token& token = tokens[at];
  if (is_sum_sign(token) || factor_joint(token) != Joint::none) return Neighbour::sign;
  const auto relation = relation_kind(token);
  if (relation && *relation != RelationKind::other && *relation != RelationKind::implies)
    return Neighbour::relation;
  if (is_sign(token, ":") && is_sign_at(tokens, at + 1, "=")) return Neighbour::relation;
  return std::nullopt;
}

/// What the place at `at`, behind a word, begins with.
Neighbour behind(TokenView tokens, std::size_t at) {
  bool gap = false;
  for (; at < tokens.size(); ++at) {
    const Token& token = tokens[at];
    if (is_gap(token)) gap = true;
    if (is_gap(token) || is_skipped(token)) continue;
    if (const auto sign = sign_at(tokens, at)) return *sign;
    if (gap || is_sign_of(token, ",;:.)]|") || is_control(token, "end")) return Neighbour::nothing;
    if (is_control_of(token, {"rvert", "}", "rbrace", "rangle", "implies", "Rightarrow"}))
      return Neighbour::nothing;
    if (is_sign_of(token, "([") || is_control_of(token, {"{", "lbrace"})) return Neighbour::bracket;
    if (word_at(tokens, at)) return Neighbour::factor;
    return is_words(token) ? Neighbour::words : Neighbour::factor;
  }
  return Neighbour::nothing;
}

/// Where scripts behind a symbol end.
std::size_t behind_scripts(TokenView tokens, std::size_t at) {
  while (true) {
    const std::size_t script = skip_blank(tokens, at);
    if (!is_script_at(tokens, script)) return at;
    at = is_sign(tokens[script], "'") ? script + 1 : script_argument_at(tokens, script + 1).next;
  }
}

bool is_change(const Token& token) {
  const std::string letter = letter_of(token);
  return letter == "\\Delta" || letter == "\\delta";
}

/// Goes through one stretch of a display and finds the words in it, from the left.
class WordFinder {
 public:
  explicit WordFinder(std::vector<PlacedWord>& found) : found_(found) {}

  /// What nests deeper than any expression that is read holds no word.
  void find(TokenView tokens, bool slot, bool raised) {
    constexpr int deepest = 200;
    if (depth_ >= deepest) return;
    ++depth_;
    const std::size_t first = found_.size();
    Side side;
    for (std::size_t at = 0; at < tokens.size();) at = step(tokens, at, side, raised);
    const bool whole = found_.size() == first + 1 && found_[first].left == Neighbour::nothing &&
                       found_[first].right == Neighbour::nothing && side.words == 1 && !side.other;
    if (slot && whole) found_[first].fills_slot = true;
    --depth_;
  }

 private:
  /// What is known where the finder is.
  struct Side {
    Neighbour left = Neighbour::nothing;
    bool gap = false;                // between what is left and here
    bool upright = false;            // the factor left of here is such a word
    int words = 0;                   // since the last boundary
    bool other = false;              // letters among them
    int operands = 0;                // the words among them
    bool words_to_relation = false;  // of the side before
    bool letter_to_relation = false;
  };

  static void passed(Side& side, Neighbour neighbour) {
    side.left = neighbour;
    side.gap = false;
    side.upright = false;
    if (neighbour == Neighbour::factor) {
      side.other = true;
      ++side.operands;
    }
  }

  static void begin_side(Side& side, Neighbour neighbour) {
    side.words_to_relation = neighbour == Neighbour::relation && side.words > 0 && !side.other;
    side.letter_to_relation =
        neighbour == Neighbour::relation && side.words == 0 && side.other && side.operands == 1;
    side.words = 0;
    side.operands = 0;
    side.other = false;
    passed(side, neighbour);
  }

  std::size_t step(TokenView tokens, std::size_t at, Side& side, bool raised) {
    const Token& token = tokens[at];
    if (is_gap(token)) side.gap = true;
    if (is_gap(token) || is_skipped(token)) return at + 1;
    if (const auto sign = sign_at(tokens, at)) {
      if (*sign == Neighbour::sign) {
        passed(side, *sign);
      } else {
        begin_side(side, *sign);
      }
      return at + (is_sign(token, ":") ? 2 : 1);
    }
    if (side.gap && side.left != Neighbour::sign && side.left != Neighbour::relation)
      begin_side(side, Neighbour::nothing);
    if (const std::size_t end = word(tokens, at, side, raised); end != at) return end;
    return other(tokens, at, side, raised);
  }

  /// A word with the change or the accent before it and the scripts behind; `at` where there is none.
  std::size_t word(TokenView tokens, std::size_t at, Side& side, bool raised) {
    std::size_t begin = at;
    if (is_change(tokens[begin])) begin = skip_narrow(tokens, begin + 1);
    std::optional<std::size_t> accent_end;
    TokenView inside = tokens;
    std::size_t inner = begin;
    if (begin < tokens.size() && is_accent(tokens[begin])) {
      const Argument argument = argument_at(tokens, begin + 1);
      inside = argument.content;
      inner = skip_blank(inside, 0);
      accent_end = argument.next;
    }
    if (inner >= inside.size()) return at;
    auto word = word_at(inside, inner);
    if (!word) return at;
    std::size_t end = inner + word->tokens.size();
    if (accent_end) {
      if (skip_blank(inside, end) != inside.size()) return at;
      end = *accent_end;
    }
    end = behind_scripts(tokens, end);
    word->left = side.left;
    word->left_is_upright = side.upright;
    word->right = behind(tokens, end);
    const std::size_t next = skip_narrow(tokens, end);
    word->right_is_upright = next < tokens.size() && word_at(tokens, next).has_value();
    word->raised = raised;
    word->among_words = side.words_to_relation;
    word->explains = side.left == Neighbour::relation && side.letter_to_relation;
    found_.push_back(*word);
    const bool other = side.other;
    passed(side, Neighbour::factor);
    side.other = other;
    side.upright = true;
    ++side.words;
    return end;
  }

  static bool is_accent(const Token& token) {
    return dots_of(token) > 0 || is_control_of(token, {"bar", "overline", "tilde", "widetilde"});
  }

  std::size_t other(TokenView tokens, std::size_t at, Side& side, bool raised) {
    const Token& token = tokens[at];
    if (token.kind == TokenKind::superscript) {
      const Argument exponent = script_argument_at(tokens, at + 1);
      find(exponent.content, false, true);
      return exponent.next;
    }
    if (token.kind == TokenKind::subscript) return script_argument_at(tokens, at + 1).next;
    if (is_control_of(token, {"begin", "end"})) return environment(tokens, at, side);
    if (is_sign_of(token, ",;:") || is_control_of(token, {"implies", "Rightarrow"})) {
      begin_side(side, Neighbour::nothing);
      return at + 1;
    }
    if (is_sign_of(token, "([|") || is_control_of(token, {"{", "lbrace", "lvert"})) {
      const bool mixed = side.other;
      passed(side, Neighbour::nothing);
      side.other = mixed;
      return at + 1;
    }
    if (is_sign_of(token, ")]")) {
      const bool mixed = side.other;
      passed(side, Neighbour::factor);
      side.other = mixed;
      return at + 1;
    }
    if (is_fraction(token)) return slots(tokens, at + 1, 2, side, raised);
    if (is_control(token, "sqrt"))
      return slots(tokens, optional_argument_at(tokens, at + 1).next, 1, side, raised);
    if (is_transparent(token)) return slots(tokens, at + 1, 1, side, raised);
    if (is_control_of(token, {"underbrace", "overbrace"})) return slots(tokens, at + 1, 1, side, raised);
    if (token.kind == TokenKind::begin_group) {
      const Argument group = argument_at(tokens, at);
      find(group.content, false, raised);
      passed(side, Neighbour::factor);
      return group.next;
    }
    if (token.kind == TokenKind::digit || is_sign(token, ".")) {
      const bool mixed = side.other;
      passed(side, Neighbour::factor);
      side.other = mixed;
      return at + 1;
    }
    passed(side, is_words(token) || is_visible_tie(token) ? Neighbour::words : Neighbour::factor);
    return token.kind == TokenKind::control && letter_of(token).empty() ? behind_arguments(tokens, at + 1)
                                                                        : at + 1;
  }

  /// `\begin{array}{cc}`: a cell begins.
  static std::size_t environment(TokenView tokens, std::size_t at, Side& side) {
    const Argument name = argument_at(tokens, at + 1);
    begin_side(side, is_control(tokens[at], "begin") ? Neighbour::nothing : Neighbour::factor);
    if (is_control(tokens[at], "end")) return name.next;
    const std::size_t columns = optional_argument_at(tokens, name.next).next;
    return text_of(name.content).starts_with("array") ? argument_at(tokens, columns).next : columns;
  }

  std::size_t slots(TokenView tokens, std::size_t at, int count, Side& side, bool raised) {
    const std::size_t before = found_.size();
    bool letters = false;
    for (int k = 0; k < count; ++k) {
      const Argument argument = argument_at(tokens, at);
      find(argument.content, true, raised);
      letters = letters || has_letter(argument.content);
      at = argument.next;
    }
    for (std::size_t k = before; k < found_.size(); ++k)
      found_[k].among_words = found_[k].among_words || (side.words_to_relation && found_[k].fills_slot);
    const bool mixed = side.other || letters;
    passed(side, Neighbour::factor);
    side.other = mixed;
    side.words += static_cast<int>(found_.size() - before);
    return at;
  }

  /// A letter outside the words.
  static bool has_letter(TokenView tokens) {
    for (std::size_t at = 0; at < tokens.size(); ++at) {
      if (const auto word = word_at(tokens, at)) {
        at += word->tokens.size() - 1;
      } else if (!letter_of(tokens[at]).empty() && !is_change(tokens[at])) {
        return true;
      }
    }
    return false;
  }

  /// The groups behind a control that is not known here: nobody looks into them.
  static std::size_t behind_arguments(TokenView tokens, std::size_t at) {
    at = optional_argument_at(tokens, at).next;
    while (is_kind_at(tokens, at, TokenKind::begin_group)) at = argument_at(tokens, at).next;
    return at;
  }

  std::vector<PlacedWord>& found_;
  int depth_ = 0;
};

}  // namespace

std::vector<PlacedWord> placed_words(TokenView tokens) {
  std::vector<PlacedWord> words;
  WordFinder(words).find(tokens, false, false);
  return words;
}

}  // namespace rigor
