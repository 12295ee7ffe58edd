// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/hole/hole_text.h"

#include <algorithm>
#include <string_view>

#include "base/ascii.h"
#include "latex/token/tokens.h"
#include "latex/token/vocabulary.h"

namespace rigor {
namespace {

/// A sum at its outermost level, or a sign before everything.
bool is_sum(const std::string& latex) {
  int depth = 0;
  for (const char c : latex) {
    if (c == '{' || c == '(' || c == '[' || c == '|') ++depth;
    if (c == '}' || c == ')' || c == ']') --depth;
    if (depth <= 0 && (c == '+' || c == '-')) return true;
  }
  return false;
}

/// Bars open and close alike, so that what comes after the first one is looked at as if it were outside.
bool has_sign_outside(const std::string& latex) {
  std::string without_bars = latex;
  std::erase(without_bars, '|');
  return is_sum(without_bars);
}

bool takes_argument(const Token& token) {
  if (token.kind == TokenKind::superscript || token.kind == TokenKind::subscript) return true;
  return is_fraction(token) || style_of(token) || dots_of(token) > 0 || is_control(token, "sqrt");
}

}  // namespace

bool is_written_hole(const SourceMap& sources, Span span) {
  for (const Token& token : lex(sources, span)) {
    if (letter_of(token) == hole_letter || is_sign(token, "?")) return true;
  }
  return false;
}

HolePlace place_of(const SourceMap& sources, Span span, bool alone) {
  HolePlace place{.alone = alone};
  const std::string_view text = sources.text(span.file);
  constexpr std::uint32_t near = 400;  // bytes that are looked at
  const Span before{span.file, span.begin - std::min(span.begin, near), span.begin};
  std::vector<Token> tokens = lex(sources, before);
  const bool blank = !tokens.empty() && is_blank(tokens.back());
  while (!tokens.empty() && is_blank(tokens.back())) tokens.pop_back();
  if (!tokens.empty()) {
    const Token& last = tokens.back();
    place.behind_control = last.kind == TokenKind::control && !last.text.empty() &&
                           is_letter(last.text.back()) && span.begin > 0 && is_letter(text[span.begin - 1]) &&
                           !blank;
    place.is_argument = takes_argument(last);
    place.beside_digit = last.kind == TokenKind::digit;
    if (last.kind == TokenKind::end_group ||
        last.kind == TokenKind::digit) {  // the second argument of a fraction
      for (std::size_t k = 0; k < tokens.size(); ++k) {
        if (!is_fraction(tokens[k])) continue;
        const Argument first = argument_at(tokens, k + 1);
        if (first.next == tokens.size()) place.is_argument = true;
      }
    }
  }
  const std::size_t behind = text.find_first_not_of(" \t", span.end);
  const bool digit = behind != std::string_view::npos && is_digit(text[behind]);
  place.beside_digit = place.beside_digit || digit;
  place.before_letter = span.end < text.size() && is_letter(text[span.end]);
  return place;
}

std::string placed(const std::string& latex, const HolePlace& place) {
  std::string text = latex;
  if (place.is_argument) return "{" + text + "}";
  const bool melts = place.beside_digit && !text.empty() && (is_digit(text[0]) || is_digit(text.back()));
  if (!place.alone && (has_sign_outside(text) || melts)) text = "\\left(" + text + "\\right)";
  if (place.behind_control && !text.empty() && is_letter(text[0])) text.insert(0, " ");
  if (place.before_letter && !text.empty() && is_letter(text.back())) text += ' ';
  return text;
}

std::string bare(const std::string& latex) {
  static constexpr std::string_view upright[] = {"\\text{", "\\mathrm{", "\\rm "};
  std::string text;
  for (std::size_t k = 0; k < latex.size(); ++k) {
    const char c = latex[k];
    const std::string_view rest = std::string_view(latex).substr(k);
    const auto face =
        std::ranges::find_if(upright, [&](std::string_view each) { return rest.starts_with(each); });
    if (face != std::end(upright)) {
      k += face->size() - 1;
      continue;
    }
    if (c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '{' || c == '}') continue;
    if (c == '\\' && k + 1 < latex.size() &&
        (latex[k + 1] == ',' || latex[k + 1] == ';' || latex[k + 1] == '!')) {
      ++k;
      continue;
    }
    text += c;
  }
  return text;
}

}  // namespace rigor
