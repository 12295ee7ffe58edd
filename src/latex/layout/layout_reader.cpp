// SPDX-License-Identifier: GPL-3.0-or-later
#include "latex/layout/layout_reader.h"

#include "base/among.h"

namespace rigor {
namespace {

constexpr unsigned most_depth = 60;

/// May a `+` or `-` after it only be a sign of what follows?
bool awaits_operand(const std::vector<Box>& parts) {
  auto last = parts.rbegin();
  while (last != parts.rend() && last->kind == BoxKind::space) ++last;
  if (last == parts.rend()) return true;
  switch (role_of(*last)) {
    case SignRole::binary:
    case SignRole::prefix:
    case SignRole::relation:
    case SignRole::opening:
    case SignRole::punctuation:
    case SignRole::big:
    case SignRole::integral:
      return true;
    default:
      return false;
  }
}

/// ∑ and lim take their scripts below and above, and so does a brace.
bool takes_limits(const Box& base) {
  if (base.limits) return true;
  if (base.kind == BoxKind::accent) return base.wide && is_one_of(base.text, {"⏞", "⏟", "⎴", "⎵"});
  return base.kind == BoxKind::sign && (base.role == SignRole::big || base.role == SignRole::word);
}

}  // namespace

Box row_box(std::vector<Box> parts) {
  if (parts.size() == 1) return std::move(parts.front());
  Box box;
  box.parts = std::move(parts);
  return box;
}

Box letter_box(std::string_view text, Typeface face) {
  Box box{.kind = BoxKind::letter, .text = std::string(text)};
  box.face = face;
  return box;
}

Box sign_box(std::string_view text, SignRole role) {
  Box box{.kind = BoxKind::sign, .text = std::string(text)};
  box.role = role;
  return box;
}

Box words_box(std::string_view text) { return {.kind = BoxKind::words, .text = std::string(text)}; }

Box space_box(double width) {
  Box box{.kind = BoxKind::space};
  box.width = width;
  return box;
}

Box fence_box(std::string_view open, Box inside, std::string_view close) {
  Box box{.kind = BoxKind::fence, .text = std::string(open), .closing = std::string(close)};
  box.parts.push_back(std::move(inside));
  return box;
}

Box fraction_box(Box above, Box below) {
  Box box{.kind = BoxKind::fraction};
  box.parts.push_back(std::move(above));
  box.parts.push_back(std::move(below));
  return box;
}

Box scripts_box(Box base, Box lower, Box upper) {
  Box box{.kind = BoxKind::scripts};
  box.limits = takes_limits(base);
  box.parts.push_back(std::move(base));
  box.parts.push_back(std::move(lower));
  box.parts.push_back(std::move(upper));
  return box;
}

bool is_empty(const Box& box) { return box.kind == BoxKind::row && box.parts.empty(); }

SignRole role_of(const Box& box) {
  if (box.kind == BoxKind::scripts) return role_of(box.parts.front());
  return box.kind == BoxKind::sign ? box.role : SignRole::ordinary;
}

Box LayoutReader::read() {
  if (context_.depth > most_depth) return words_box(text_of(tokens_));
  while (at_ < tokens_.size()) step();
  return row_box(std::move(parts_));
}

Box LayoutReader::inner(TokenView tokens, Typeface face) const {
  return LayoutReader(tokens, {context_.depth + 1, face}).read();
}

TokenView LayoutReader::take_argument() {
  const Argument argument = argument_at(tokens_, at_);
  at_ = argument.next;
  return argument.content;
}

std::optional<TokenView> LayoutReader::take_optional() {
  const Argument argument = optional_argument_at(tokens_, at_);
  if (argument.next == at_) return std::nullopt;
  at_ = argument.next;
  return argument.content;
}

/// A control that takes arguments comes with them: `\frac12` in `^\frac12`.
Box LayoutReader::argument(Typeface face) {
  at_ = skip_blank(tokens_, at_);
  if (is_kind_at(tokens_, at_, TokenKind::control)) {
    const Argument script = script_argument_at(tokens_, at_);
    at_ = script.next;
    return inner(script.content, face);
  }
  return inner(take_argument(), face);
}

Box LayoutReader::argument() { return argument(context_.face); }

bool LayoutReader::next_is(std::string_view sign) const {
  const std::size_t next = skip_blank(tokens_, at_);
  return next < tokens_.size() && is_sign(tokens_[next], sign);
}

void LayoutReader::skip_star() {
  if (next_is("*")) at_ = skip_blank(tokens_, at_) + 1;
}

void LayoutReader::step() {
  const Token token = tokens_[at_];
  switch (token.kind) {
    case TokenKind::begin_group:
      return push(inner(take_argument()));
    case TokenKind::end_group:
      push(words_box("}"));
      break;
    case TokenKind::superscript:
    case TokenKind::subscript:
      return scripts();
    case TokenKind::digit:
      return number();
    case TokenKind::letter:
      letter(token);
      break;
    case TokenKind::parameter:
      push(words_box("#" + std::string(token.text)));
      break;
    case TokenKind::other:
      if (token.text == "'") return scripts();
      letter(token);
      break;
    case TokenKind::control:
      ++at_;
      return control(token.text);
    case TokenKind::align:
    case TokenKind::space:
    case TokenKind::paragraph:
      break;
  }
  ++at_;
}

void LayoutReader::letter(const Token& token) {
  if (token.text == "$") return;
  if (token.text == "~") return push(space_box(1.0 / 3));
  if (const auto printed = sign_of_character(token.text)) return sign(*printed);
  if (token.kind == TokenKind::other) return push(sign_box(token.text, SignRole::ordinary));
  push(letter_box(token.text, context_.face));
}

void LayoutReader::number() {
  std::string digits;
  const auto is_point = [&](std::size_t at) {
    return is_sign(tokens_[at], ".") && at + 1 < tokens_.size() && tokens_[at + 1].kind == TokenKind::digit;
  };
  while (at_ < tokens_.size() && (tokens_[at_].kind == TokenKind::digit || is_point(at_)))
    digits += tokens_[at_++].text;
  Box box{.kind = BoxKind::number, .text = digits};
  box.face = context_.face;
  push(std::move(box));
}

void LayoutReader::sign(PrintedSign printed, int size) {
  if (printed.letter) return push(letter_box(printed.text, context_.face));
  if (printed.role == SignRole::ordinary) {
    const bool is_word = static_cast<unsigned char>(printed.text.front()) >= 0xCE &&
                         static_cast<unsigned char>(printed.text.front()) <= 0xCF;  // Γ to ϖ
    if (is_word) {
      const bool bold = context_.face == Typeface::bold || context_.face == Typeface::bold_italic;
      return push(letter_box(printed.text, bold ? Typeface::bold : Typeface::upright));
    }
  }
  const bool may_be_prefix = is_one_of(printed.text, {"+", "−", "±", "∓"});
  if (may_be_prefix && awaits_operand(parts_)) printed.role = SignRole::prefix;
  Box box = sign_box(printed.text, printed.role);
  box.size = size;
  push(std::move(box));
}

/// All of `_a^b'`, in any order, for the part before it.
void LayoutReader::scripts() {
  Box base;
  if (!parts_.empty() && parts_.back().kind != BoxKind::space &&
      role_of(parts_.back()) != SignRole::relation) {
    base = std::move(parts_.back());
    parts_.pop_back();
  }
  std::vector<Box> lower;
  std::vector<Box> upper;
  std::size_t primes = 0;
  for (std::size_t next = at_; next < tokens_.size(); next = skip_blank(tokens_, at_)) {
    const Token& token = tokens_[next];
    const bool is_script = token.kind == TokenKind::superscript || token.kind == TokenKind::subscript;
    if (!is_script && !is_sign(token, "'")) break;
    at_ = next + 1;
    if (!is_script) {
      ++primes;
      continue;
    }
    Box content =
        argument(token.kind == TokenKind::subscript && context_.face != Typeface::upright ? Typeface::italic
                                                                                          : context_.face);
    if (is_empty(content)) continue;
    (token.kind == TokenKind::subscript ? lower : upper).push_back(std::move(content));
  }
  std::string marks;
  for (std::size_t k = 0; k < primes; ++k) marks += "′";
  if (!marks.empty()) upper.insert(upper.begin(), sign_box(marks, SignRole::ordinary));
  if (lower.empty() && upper.empty()) return push(std::move(base));
  push(scripts_box(std::move(base), row_box(std::move(lower)), row_box(std::move(upper))));
}

Box layout_of(TokenView tokens) { return LayoutReader(tokens, {}).read(); }

}  // namespace rigor
