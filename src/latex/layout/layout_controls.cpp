// SPDX-License-Identifier: GPL-3.0-or-later
// Controls that are more than a sign.
#include <algorithm>

#include "base/among.h"
#include "base/ascii.h"
#include "latex/layout/layout_reader.h"
#include "latex/token/words.h"

namespace rigor {
namespace {

/// 1 for `\big` to 4 for `\Bigg`, whatever letter says on which side the bracket stands; 0 for other
/// controls.
int bracket_size(std::string_view name) {
  if (name.ends_with('l') || name.ends_with('r') || name.ends_with('m')) name.remove_suffix(1);
  static const WordMap<int> sizes{{"big", 1}, {"Big", 2}, {"bigg", 3}, {"Bigg", 4}};
  return sizes.find(name).value_or(0);
}

bool only_letters(TokenView tokens) {
  return std::ranges::all_of(tokens, [](const Token& token) {
    return (token.kind == TokenKind::letter && !sign_of_character(token.text)) ||
           token.kind == TokenKind::digit || is_blank(token);
  });
}

/// The place of the `\right` that closes the `\left` before `at`.
std::size_t closing_right(TokenView tokens, std::size_t at) {
  int open = 1;
  for (; at < tokens.size(); ++at) {
    if (is_control(tokens[at], "left")) ++open;
    if (is_control(tokens[at], "right") && --open == 0) break;
  }
  return at;
}

}  // namespace

void LayoutReader::control(std::string_view name) {
  if (name == "begin") return environment();
  if (name == "left") return left_fence();
  if (name == "over" || name == "atop" || name == "choose") return over(name);
  if (name == "not") return negated();
  if (vanishing(name) || bracket(name) || fraction(name) || stacked(name) || words(name) || kept(name) ||
      quantity(name) || physics(name))
    return;
  if (const auto face = typeface_of(name)) {
    const bool is_switch = is_one_of(name, {"bf", "rm", "it", "sf", "tt", "cal"});
    if (is_switch) {
      context_.face = *face;
      return;
    }
    skip_star();
    if (*face == Typeface::upright) {
      const Argument peeked = argument_at(tokens_, at_);
      if (!peeked.content.empty() && only_letters(peeked.content)) {
        at_ = peeked.next;
        return push(letter_box(text_of(peeked.content), Typeface::upright));
      }
    }
    return push(argument(*face));
  }
  if (const auto accent = accent_of(name)) {
    Box box{.kind = BoxKind::accent, .text = std::string(accent->text)};
    box.wide = accent->wide;
    box.below = accent->below;
    box.parts.push_back(argument());
    return push(std::move(box));
  }
  if (const std::string_view word = printed_function(name); !word.empty())
    return function_word(letter_box(word, Typeface::upright));
  if (const auto printed = sign_of_control(name)) return sign(*printed);
  if (name == "limits") {
    if (!parts_.empty()) parts_.back().limits = true;
    return;
  }
  if (const auto width = space_of(name)) {
    if (*width != 0) push(space_box(*width));
    return;
  }
  if (name == "\\" || name == "cr" || name == "newline") return push(space_box(1));
  if (name == "\n" || name == "\t" || name == "\r") return push(space_box(1.0 / 3));
  push(words_box("\\" + std::string(name)));
}

void LayoutReader::function_word(Box word) {
  const bool apart =
      !parts_.empty() && role_of(parts_.back()) == SignRole::ordinary && parts_.back().kind != BoxKind::space;
  if (apart) push(space_box(0.1667));
  push(std::move(word));
  const std::size_t next = skip_blank(tokens_, at_);
  if (next < tokens_.size() &&
      (tokens_[next].kind == TokenKind::superscript || tokens_[next].kind == TokenKind::subscript))
    scripts();
  const std::size_t behind = skip_blank(tokens_, at_);
  if (behind >= tokens_.size()) return;
  const bool bracketed = is_sign_of(tokens_[behind], "([") || is_control(tokens_[behind], "left") ||
                         is_sign_of(tokens_[behind], "),");
  if (!bracketed) push(space_box(0.1667));
}

std::optional<PrintedSign> LayoutReader::delimiter() {
  at_ = skip_blank(tokens_, at_);
  if (at_ >= tokens_.size()) return std::nullopt;
  const Token& token = tokens_[at_++];
  if (is_sign(token, ".")) return std::nullopt;
  if (token.kind == TokenKind::control) {
    const auto printed = sign_of_control(token.text);
    return printed ? printed : PrintedSign{token.text, SignRole::ordinary};
  }
  if (is_sign(token, "<")) return PrintedSign{"⟨", SignRole::opening};
  if (is_sign(token, ">")) return PrintedSign{"⟩", SignRole::closing};
  const auto printed = sign_of_character(token.text);
  return printed ? printed : PrintedSign{token.text, SignRole::ordinary};
}

void LayoutReader::left_fence() {
  const auto open = delimiter();
  const std::size_t end = closing_right(tokens_, at_);
  Box inside = inner(tokens_.subspan(at_, end - at_));
  at_ = std::min(end + 1, tokens_.size());
  const auto close = end < tokens_.size() ? delimiter() : std::nullopt;
  push(fence_box(open ? open->text : "", std::move(inside), close ? close->text : ""));
}

bool LayoutReader::bracket(std::string_view name) {
  const int size = bracket_size(name);
  if (size == 0 && name != "middle" && name != "right") return false;
  auto printed = delimiter();
  if (!printed) return true;
  if (name.ends_with('l')) printed->role = SignRole::opening;
  if (name.ends_with('r')) printed->role = SignRole::closing;
  sign(*printed, size);
  if (name == "middle") parts_.back().wide = true;
  return true;
}

bool LayoutReader::fraction(std::string_view name) {
  static const WordSet fractions("frac tfrac dfrac cfrac nicefrac sfrac");
  static const WordSet binomials("binom dbinom tbinom");
  const bool ruled = fractions.contains(name);
  if (ruled || binomials.contains(name)) {
    Box above = argument();
    Box box = fraction_box(std::move(above), argument());
    box.ruled = ruled;
    if (name.starts_with('t') || name == "nicefrac" || name == "sfrac") box.size = -1;
    if (name.starts_with('d') || name == "cfrac") box.size = 1;
    push(ruled ? std::move(box) : fence_box("(", std::move(box), ")"));
    return true;
  }
  if (name != "sqrt") return false;
  Box root{.kind = BoxKind::root};
  const auto degree = take_optional();
  root.parts.push_back(argument());
  if (degree) root.parts.push_back(inner(*degree));
  push(std::move(root));
  return true;
}

/// `a \over b`: everything before it in the group, and everything after it.
void LayoutReader::over(std::string_view name) {
  Box above = row_box(std::move(parts_));
  parts_.clear();
  Box box = fraction_box(std::move(above), inner(tokens_.subspan(at_)));
  at_ = tokens_.size();
  box.ruled = name == "over";
  push(name == "choose" ? fence_box("(", std::move(box), ")") : std::move(box));
}

void LayoutReader::negated() {
  at_ = skip_blank(tokens_, at_);
  if (at_ >= tokens_.size()) return push(words_box("\\not"));
  const Token& token = tokens_[at_++];
  const auto printed =
      token.kind == TokenKind::control ? sign_of_control(token.text) : sign_of_character(token.text);
  const std::string text = printed ? std::string(printed->text) : std::string(token.text);
  push(sign_box(text == "=" ? "≠" : text + "̸", SignRole::relation));
}

/// One thing above or below another.
bool LayoutReader::stacked(std::string_view name) {
  static const WordTable arrows(R"(xrightarrow →  xleftarrow ←  xleftrightarrow ↔  xmapsto ↦
      xRightarrow ⇒  xLeftarrow ⇐  xLeftrightarrow ⇔  xlongequal =)");
  if (const std::string_view arrow = arrows.find(name); !arrow.empty()) {
    const auto lower = take_optional();
    Box upper = argument();
    Box base = sign_box(arrow, SignRole::relation);
    base.wide = base.limits = true;
    push(scripts_box(std::move(base), lower ? inner(*lower) : Box{}, std::move(upper)));
    return true;
  }
  if (name == "stackrel" || name == "overset" || name == "underset") {
    Box script = argument();
    Box base = argument();
    base.limits = true;
    const bool below = name == "underset";
    Box lower = below ? std::move(script) : Box{};
    push(scripts_box(std::move(base), std::move(lower), below ? Box{} : std::move(script)));
    return true;
  }
  if (name != "substack") return false;
  push(table(take_argument(), TableAlignment::centre, {context_.depth + 1, context_.face}));
  return true;
}

bool LayoutReader::vanishing(std::string_view name) {
  static const WordSet one(
      "vphantom vspace color footnote hypertarget label index setcounter footnotemark footnotetext");
  if (one.contains(name)) {
    skip_star();
    static_cast<void>(take_argument());
    return true;
  }
  if (name == "tag") {
    const bool bare = next_is("*");
    skip_star();
    const std::string text = text_line(take_argument());
    tag_ = bare ? text : "(" + text + ")";
    return true;
  }
  static const WordSet lengths("hskip vskip mskip kern mkern hglue");
  if (!lengths.contains(name)) return false;
  at_ = skip_blank(tokens_, at_);
  const std::size_t begin = at_;
  while (at_ < tokens_.size() && (tokens_[at_].kind == TokenKind::digit || is_sign_of(tokens_[at_], ".-+")))
    ++at_;
  if (at_ > begin) at_ = std::min(at_ + 2, tokens_.size());  // the unit
  return true;
}

/// What its argument is kept of, perhaps changed.
bool LayoutReader::kept(std::string_view name) {
  static const WordMap<BoxKind> kinds{{"boxed Aboxed", BoxKind::framed},
                                      {"phantom hphantom", BoxKind::hidden},
                                      {"cancel bcancel xcancel", BoxKind::struck}};
  if (const auto kind = kinds.find(name)) {
    Box box{.kind = *kind};
    box.parts.push_back(argument());
    push(std::move(box));
    return true;
  }
  if (name == "cancelto") {
    Box value = argument();
    Box box{.kind = BoxKind::struck};
    box.parts.push_back(argument());
    push(scripts_box(std::move(box), Box{}, std::move(value)));
    return true;
  }
  if (name == "textcolor" || name == "colorbox") {
    static_cast<void>(take_argument());
    push(argument());
    return true;
  }
  if (name == "hspace") {
    skip_star();
    static_cast<void>(take_argument());
    push(space_box(1));
    return true;
  }
  if (name == "mathop") {
    push(argument());
    parts_.back().limits = true;
    return true;
  }
  return false;
}

}  // namespace rigor
