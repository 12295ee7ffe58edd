// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/parse/parse_indices.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/among.h"
#include "base/ascii.h"
#include "latex/token/cover_tokens.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

bool holds_words(const Token& token) {
  const auto style = style_of(token);
  return is_words(token) || (style && style->upright) || is_control(token, "mathit");
}

std::string letters_of(TokenView tokens) {
  std::string letters;
  for (const Token& token : tokens) {
    if (token.kind == TokenKind::letter && token.text.size() == 1) letters += token.text;
  }
  return letters;
}

/// A run of plain letters from `at` on; only the letters themselves.
TokenView letter_run(TokenView tokens, std::size_t at) {
  std::size_t end = at;
  while (is_kind_at(tokens, end, TokenKind::letter) && tokens[end].text.size() == 1) ++end;
  return tokens.subspan(at, end - at);
}

/// `A_\perp`, `n_+`, `M_\odot`: signs that name a quantity.
bool is_label_sign(const Token& token) {
  static const WordSet controls(
      "perp bot parallel pm mp infty odot oplus ominus otimes circ ast star "
      "uparrow downarrow rightarrow leftarrow triangle");
  return is_control_of(token, controls);
}

/// `r_{\max}` is `r_{\text{max}}`.
bool is_label_word(const Token& token) {
  static const WordSet controls("max min sup inf lim det dim ker arg");
  return is_control_of(token, controls);
}

/// `n+1`, `k-1`, `1/2`, `i\to f`, `-1`: signs and numbers together are one label. Without a sign among them
/// they are none, nor are those with a comma or a relation.
bool is_label_of_signs(TokenView tokens) {
  bool sign = false;
  for (std::size_t at = 0; at < tokens.size(); ++at) {
    const Token& token = tokens[at];
    const bool joins = is_sign_of(token, "+-/") || is_control_of(token, {"to", "rightarrow", "leftarrow"});
    sign = sign || joins;
    const std::string letter = letter_of(token);
    const bool part = joins || is_blank(token) || is_spacing(token) || token.kind == TokenKind::digit ||
                      (!letter.empty() && letter != hole_letter);
    if (!part) return false;
  }
  return sign && tokens.size() > 1;
}

/// The letters of `\text{lab}`, `\mathrm{lab}`, `\rm lab`, if there is nothing else.
std::string word_of(TokenView tokens) {
  if (tokens.empty() || !holds_words(tokens[0])) return {};
  const Argument words = argument_at(tokens, 1);
  const bool switches = is_control(tokens[0], "rm");
  const TokenView inside = trim(switches ? tokens.subspan(1) : words.content);
  if (!switches && words.next != tokens.size()) return {};
  const bool plain = !inside.empty() && std::ranges::all_of(inside, [](const Token& token) {
    return token.kind == TokenKind::letter && token.text.size() == 1;
  });
  return plain ? text_of(inside) : std::string();
}

bool is_number_or_capital(TokenView tokens) {
  const auto is_digit = [](const Token& token) { return token.kind == TokenKind::digit; };
  if (tokens.empty() || tokens.size() > 2) return false;
  if (std::ranges::all_of(tokens, is_digit)) return true;
  const Token& only = tokens[0];
  return tokens.size() == 1 && only.kind == TokenKind::letter && only.text.size() == 1 &&
         is_capital_letter(only.text[0]);
}

/// What `\mathbf k` or `x_0` of `\omega_{\mathbf k}`, `f_{x_0}` stands for is told apart by its letter.
/// Letters that indices have can have subscripts of their own: `T_{i_1}`.
bool names_a_thing(const Token& token) {
  static constexpr std::string_view indices = "ijklmn";
  const std::string letter = letter_of(token);
  return !letter.empty() && letter != hole_letter && !is_greek(letter) &&
         indices.find(letter) == std::string_view::npos;
}

/// `\mathbf{k}`, `\hat{n}`, `\mathcal{D}`, `x_{0}`, `(2)`: the label of a quantity of its own; empty for
/// others.
std::string label_of_a_thing(TokenView tokens) {
  static const WordSet faces("mathbf boldsymbol bm vec hat bar tilde mathcal mathscr mathfrak mathbb");
  if (tokens.size() < 2) return {};
  if (is_sign(tokens.front(), "(") && is_sign(tokens.back(), ")")) {
    const TokenView inside = trim(tokens.subspan(1, tokens.size() - 2));
    return is_number_or_capital(inside) ? "(" + text_of(inside) + ")" : std::string();
  }
  const bool face = is_control_of(tokens[0], faces);
  if (!face && (tokens[1].kind != TokenKind::subscript || !names_a_thing(tokens[0]))) return {};
  const Argument argument = argument_at(tokens, face ? 1 : 2);
  const TokenView inside = trim(argument.content);
  if (inside.empty() || argument.next != tokens.size()) return {};
  const std::string letter = inside.size() == 1 ? letter_of(inside[0]) : std::string();
  if (face) {
    const bool accent = is_control_of(tokens[0], {"hat", "bar", "tilde"});
    const bool angle = is_one_of(letter, {"\\theta", "\\phi", "\\varphi", "\\rho"});
    if (accent && !angle && !names_a_thing(inside[0])) return {};  // `T_{\bar\jmath}`
    const bool bold = is_control_of(tokens[0], {"boldsymbol", "bm", "vec"});
    const std::string_view name = bold ? "mathbf" : tokens[0].text;
    return letter.empty() || letter == hole_letter ? std::string() : fmt::format("\\{}{{{}}}", name, letter);
  }
  const bool label = !letter.empty() || inside[0].kind == TokenKind::digit || !word_of(inside).empty();
  return label ? fmt::format("{}_{{{}}}", letter_of(tokens[0]), text_of(inside)) : std::string();
}

/// `n+1`, `i\to f`
std::string without_blanks(TokenView tokens) {
  std::string text;
  for (const Token& token : tokens) {
    if (is_blank(token) || is_spacing(token)) continue;
    const bool joins =
        token.kind == TokenKind::letter && text.find('\\') != std::string::npos && is_letter(text.back());
    text += (joins ? " " : "") + text_of({&token, 1});
  }
  return text;
}

class IndexReader {
 public:
  explicit IndexReader(TokenView tokens, int depth = 0) : tokens_(trim(tokens)), depth_(depth) {}

  IndexReading read() {
    std::string text = depth_ == 0 ? label_of_a_thing(tokens_) : std::string();
    if (depth_ == 0 && text.empty() && is_label_of_signs(tokens_)) {
      text = without_blanks(tokens_);
    }
    if (!text.empty()) {
      add(std::move(text), IndexForm::word, span_of(tokens_));
      return std::move(reading_);
    }
    while (at_ < tokens_.size() && !reading_.obstacle) step();
    return std::move(reading_);
  }

 private:
  void add(std::string text, IndexForm form, Span span) {
    reading_.indices.push_back({std::move(text), form, 0, span});
  }

  void step() {
    const Token& token = tokens_[at_];
    if (is_blank(token) || is_spacing(token)) {
      ++at_;
    } else if (token.kind == TokenKind::begin_group) {
      const Argument group = argument_at(tokens_, at_);
      if (depth_ > 8) return refuse("braces in a subscript nest too deep");
      IndexReading inner = IndexReader(group.content, depth_ + 1).read();
      reading_.indices.insert(reading_.indices.end(), inner.indices.begin(), inner.indices.end());
      if (inner.obstacle) reading_.obstacle = inner.obstacle;
      at_ = group.next;
    } else if (is_control_of(token, {"rm", "sf", "it"})) {  // {\\rm in}
      const TokenView words = trim(tokens_.subspan(at_ + 1));
      if (!words.empty()) add(text_of(words), IndexForm::word, cover(token.span, span_of(words)));
      at_ = tokens_.size();
    } else if (holds_words(token)) {
      const Argument words = argument_at(tokens_, at_ + 1);
      add(text_of(words.content), IndexForm::word, cover(token.span, words.content));
      at_ = words.next;
    } else if (token.kind == TokenKind::digit) {
      add(std::string(token.text), IndexForm::digit, token.span);
      ++at_;
    } else if (is_sign(token, "'") || is_control(token, "prime")) {
      prime();
    } else if (token.kind == TokenKind::superscript) {
      superscript();
    } else {
      letter(token);
    }
  }

  void prime() {
    if (reading_.indices.empty()) {
      refuse("a prime without an index before it");
    } else {
      ++reading_.indices.back().primes;
    }
    ++at_;
  }

  void superscript() {
    const Argument argument = argument_at(tokens_, at_ + 1);
    const bool primes =
        !trim(argument.content).empty() && std::ranges::all_of(argument.content, [](const Token& token) {
          return is_control(token, "prime") || is_sign(token, "'");
        });
    if (!primes || reading_.indices.empty()) {
      refuse("a superscript inside a subscript is not read");
      return;
    }
    reading_.indices.back().primes = static_cast<std::uint8_t>(argument.content.size());
    at_ = argument.next;
  }

  void letter(const Token& token) {
    const TokenView run = letter_run(tokens_, at_);
    if (is_subscript_word(letters_of(run))) {
      add(letters_of(run), IndexForm::word, span_of(run));
      at_ += run.size();
      return;
    }
    const std::string letter = letter_of(token);
    const bool lone_sign = tokens_.size() == 1 && is_sign_of(token, "+-*");
    if (letter.empty() && (lone_sign || is_label_sign(token))) {
      add(text_of({&token, 1}), IndexForm::word, token.span);
      ++at_;
      return;
    }
    if (is_label_word(token)) {
      add(std::string(token.text), IndexForm::word, token.span);
      ++at_;
      return;
    }
    if (letter == hole_letter) {
      refuse("a hole is not an index");
      return;
    }
    if (letter.empty()) {
      if (separates_labels(token)) {
        ++at_;
        return;
      }
      refuse(is_sign(token, ",") ? "a comma in a subscript can separate indices or be a derivative"
                                 : fmt::format("`{}` in a subscript is not read", text_of({&token, 1})));
      return;
    }
    add(letter, is_greek(letter) ? IndexForm::greek : IndexForm::letter, token.span);
    ++at_;
  }

  /// `C_{V,\text{m}}`, `T_{\text{in},1}`, `v_{\text{ext},x}`, `v_{B,0}`: a comma beside a word, or between a
  /// capital and another or a number, is no derivative.
  [[nodiscard]] bool separates_labels(const Token& token) const {
    if (!is_sign(token, ",") || reading_.indices.empty()) return false;
    const std::size_t next = skip_blank(tokens_, at_ + 1);
    if (next >= tokens_.size()) return false;
    const bool word_behind = holds_words(tokens_[next]) || is_label_word(tokens_[next]) ||
                             is_subscript_word(letters_of(letter_run(tokens_, next)));
    const WrittenIndex& before = reading_.indices.back();
    const auto is_capital = [](std::string_view letter) {
      return letter.size() == 1 && is_capital_letter(letter[0]);
    };
    const bool name_behind = tokens_[next].kind == TokenKind::digit || is_capital(letter_of(tokens_[next]));
    return word_behind || before.form == IndexForm::word || (is_capital(before.text) && name_behind);
  }

  void refuse(std::string message) {
    reading_.obstacle = Obstacle{DiagnosticKind::unsupported, std::move(message), {}};
    at_ = tokens_.size();
  }

  TokenView tokens_;
  int depth_;
  std::size_t at_ = 0;
  IndexReading reading_;
};

}  // namespace

IndexReading read_indices(TokenView tokens) { return IndexReader(tokens).read(); }

std::optional<WrittenIndex> read_upper_label(TokenView tokens) {
  tokens = trim(tokens);
  if (tokens.empty()) return std::nullopt;
  const auto label = [&](const std::string& text) {
    return WrittenIndex{fmt::format("^{{{}}}", text), IndexForm::word, 0, span_of(tokens)};
  };
  if (tokens.size() == 1 && is_control_of(tokens[0], {"max", "min"})) return label(text_of(tokens));
  if (tokens.size() > 2 && is_sign(tokens.front(), "(") && is_sign(tokens.back(), ")")) {
    const TokenView inside = trim(tokens.subspan(1, tokens.size() - 2));
    if (is_number_or_capital(inside)) return label("(" + text_of(inside) + ")");
    const std::string word = word_of(inside);
    return word.empty() ? std::nullopt : std::optional(label("(\\text{" + word + "})"));
  }
  static const WordSet others("T t tr Tr H h th st nd rd i j d e x dag adj");  // a transpose, a count, a unit
  const std::string word = word_of(tokens);
  return word.empty() || others.contains(word) ? std::nullopt : std::optional(label("\\text{" + word + "}"));
}

SumReading read_sum_bounds(TokenView lower, TokenView upper) {
  SumReading reading;
  const auto equal = std::ranges::find_if(lower, [](const Token& token) { return is_sign(token, "="); });
  const TokenView names = lower.first(static_cast<std::size_t>(equal - lower.begin()));
  if (equal != lower.end()) reading.sum.from = text_of(lower.subspan(names.size() + 1));
  reading.sum.to = text_of(upper);
  Tokens letters;
  std::copy_if(names.begin(), names.end(), std::back_inserter(letters),
               [](const Token& token) { return !is_sign(token, ","); });
  IndexReading indices = read_indices(letters);
  if (indices.obstacle) {
    reading.obstacle =
        Obstacle{DiagnosticKind::unsupported, fmt::format("a sum over `{}` is not read", text_of(lower)), {}};
  }
  reading.sum.indices = std::move(indices.indices);
  if (reading.sum.indices.empty() && !reading.obstacle) {
    reading.obstacle = Obstacle{DiagnosticKind::unsupported,
                                "the sum does not say over which index",
                                {"write `\\sum_\\alpha` or `\\sum_i`"}};
  }
  return reading;
}

}  // namespace rigor
