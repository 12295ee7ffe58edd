// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/macro/faces.h"

#include <algorithm>
#include <optional>

#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

bool is_bold_alphabet(const Token& token) {
  static const WordSet names("mathbf boldsymbol bm pmb mathbfit symbf symbfit vb vectorbold");
  return is_control_of(token, names);
}

bool is_letter_token(const Token& token) {
  const std::string letter = letter_of(token);
  return !letter.empty() && letter != hole_letter;
}

bool is_accent(const Token& token) {
  const auto style = style_of(token);
  return (style && style->face == Face::plain && style->accent != Accent::none) || dots_of(token) > 0;
}

/// What stands below a face.
class FacedExpression {
 public:
  explicit FacedExpression(TokenView content) : content_(content) {}

  /// A product of letters, or a sum of them.
  bool is_spread() {
    for (at_ = 0; at_ < content_.size();) {
      if (!step()) return false;
    }
    return letters_ > 0 && (products_ || (sums_ && !numbers_));
  }

 private:
  bool step() {
    const Token& token = content_[at_];
    if (is_blank(token) || is_spacing(token) || is_bracket_size(token)) return pass(beside_letter_);
    const Joint joint = factor_joint(token);
    sums_ = sums_ || is_sum_sign(token);
    products_ = products_ || joint == Joint::dot || joint == Joint::cross;
    numbers_ = numbers_ || token.kind == TokenKind::digit || token.kind == TokenKind::superscript;
    const bool sign = is_sum_sign(token) || joint == Joint::dot || joint == Joint::cross;
    if (sign || is_sign_of(token, "()[]") || token.kind == TokenKind::digit) return pass(false);
    if (is_script(token)) return script(token);
    if (is_control(token, "nabla")) return pass(true);
    if (is_accent(token)) return accent();
    if (!is_letter_token(token) || beside_letter_) return false;
    ++letters_;
    return pass(true);
  }

  bool pass(bool beside_letter) {
    beside_letter_ = beside_letter;
    ++at_;
    return true;
  }

  bool script(const Token& token) {
    at_ = is_sign(token, "'") ? at_ + 1 : script_argument_at(content_, at_ + 1).next;
    return true;
  }

  bool accent() {
    const Argument argument = argument_at(content_, at_ + 1);
    const TokenView inside = trim(argument.content);
    if (beside_letter_ || inside.size() != 1 || !is_letter_token(inside[0])) return false;
    ++letters_;
    beside_letter_ = true;
    at_ = argument.next;
    return true;
  }

  TokenView content_;
  std::size_t at_ = 0;
  int letters_ = 0;
  bool beside_letter_ = false;  // the last sign is a letter, or acts on one
  bool products_ = false;
  bool sums_ = false;
  bool numbers_ = false;  // powers among them
};

void add_faced(Tokens& result, const Token& face, const Token& letter) {
  result.push_back(face);
  result.push_back({TokenKind::begin_group, "{", letter.span});
  result.push_back(letter);
  result.push_back({TokenKind::end_group, "}", letter.span});
}

void add_spread(Tokens& result, const Token& face, TokenView content) {
  for (std::size_t at = 0; at < content.size();) {
    const Token& token = content[at];
    if (is_script(token) && !is_sign(token, "'")) {
      const std::size_t next = script_argument_at(content, at + 1).next;
      result.insert(result.end(), content.begin() + static_cast<std::ptrdiff_t>(at),
                    content.begin() + static_cast<std::ptrdiff_t>(next));
      at = next;
      continue;
    }
    const bool bare = !result.empty() && is_accent(result.back());  // `\dot r`: an argument without braces
    if (bare && is_letter_token(token)) result.push_back({TokenKind::begin_group, "{", token.span});
    if (is_letter_token(token)) {
      add_faced(result, face, token);
    } else {
      result.push_back(token);
    }
    if (bare && is_letter_token(token)) result.push_back({TokenKind::end_group, "}", token.span});
    ++at;
  }
}

/// The end of the group that `at` is in, or of the tokens.
std::size_t end_of_group(TokenView tokens, std::size_t at) {
  int depth = 0;
  for (; at < tokens.size(); ++at) {
    if (tokens[at].kind == TokenKind::begin_group) ++depth;
    if (tokens[at].kind == TokenKind::end_group && --depth < 0) break;
  }
  return at;
}

/// What the face at `at` is for.
std::optional<Argument> faced_part(TokenView tokens, std::size_t at) {
  if (is_control(tokens[at], "bf")) {
    const std::size_t end = end_of_group(tokens, at + 1);
    return Argument{tokens.subspan(at + 1, end - at - 1), end};
  }
  if (!is_bold_alphabet(tokens[at])) return std::nullopt;
  std::size_t open = at + 1;
  if (is_sign_at(tokens, open, "*")) ++open;
  open = skip_blank(tokens, open);
  if (!is_kind_at(tokens, open, TokenKind::begin_group)) return std::nullopt;
  return argument_at(tokens, open);
}

bool is_operand(const Token& token) {
  return token.kind == TokenKind::letter || token.kind == TokenKind::digit ||
         (token.kind == TokenKind::control && is_letter_token(token));
}

bool is_double_star(TokenView tokens, std::size_t at) {
  return is_sign_at(tokens, at, "*") && is_sign_at(tokens, at + 1, "*");
}

/// `**A**`, `**\omega_1**`: the place of the closing stars; nothing for anything else.
std::optional<std::size_t> closing_stars(TokenView tokens, std::size_t at) {
  if (!is_double_star(tokens, at) || at + 2 >= tokens.size() || !is_letter_token(tokens[at + 2]))
    return std::nullopt;
  std::size_t close = at + 3;
  if (is_kind_at(tokens, close, TokenKind::subscript)) close = script_argument_at(tokens, close + 1).next;
  if (!is_double_star(tokens, close)) return std::nullopt;
  const bool behind_operand = at > 0 && (is_operand(tokens[at - 1]) || is_sign_of(tokens[at - 1], ")]"));
  const bool before_operand =
      close + 2 < tokens.size() && (is_operand(tokens[close + 2]) || is_sign_of(tokens[close + 2], "(["));
  if (behind_operand && before_operand) return std::nullopt;
  return close;
}

}  // namespace

Tokens with_faces_spread(Tokens tokens) {
  const auto faced = [](const Token& token) { return is_bold_alphabet(token) || is_control(token, "bf"); };
  if (std::ranges::none_of(tokens, faced)) return tokens;
  Tokens result;
  result.reserve(tokens.size());
  for (std::size_t at = 0; at < tokens.size();) {
    const auto part = faced_part(tokens, at);
    if (!part || !FacedExpression(part->content).is_spread()) {
      result.push_back(tokens[at++]);
      continue;
    }
    const bool alphabet = is_bold_alphabet(tokens[at]);
    const Token face{TokenKind::control, alphabet ? tokens[at].text : "mathbf", tokens[at].span};
    if (alphabet) result.push_back({TokenKind::begin_group, "{", face.span});
    add_spread(result, face, part->content);
    if (alphabet) result.push_back({TokenKind::end_group, "}", tokens[part->next - 1].span});
    at = part->next;
  }
  return result;
}

Tokens with_starred_faces(Tokens tokens) {
  Tokens result;
  result.reserve(tokens.size());
  for (std::size_t at = 0; at < tokens.size();) {
    const auto close = closing_stars(tokens, at);
    if (!close) {
      result.push_back(tokens[at++]);
      continue;
    }
    result.push_back({TokenKind::control, "mathbf", cover(tokens[at].span, tokens[at + 1].span)});
    result.push_back({TokenKind::begin_group, "{", tokens[at + 1].span});
    result.insert(result.end(), tokens.begin() + static_cast<std::ptrdiff_t>(at + 2),
                  tokens.begin() + static_cast<std::ptrdiff_t>(*close));
    result.push_back({TokenKind::end_group, "}", tokens[*close + 1].span});
    at = *close + 2;
  }
  return result;
}

}  // namespace rigor
