// SPDX-License-Identifier: GPL-3.0-or-later
// Classes of bytes, as TeX and Markdown see them; the same in every locale.
#pragma once

#include <string_view>

namespace rigor {

[[nodiscard]] constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
/// In the name of a control word: also `@`, which packages and preambles use.
[[nodiscard]] constexpr bool is_word_letter(char c) { return is_letter(c) || c == '@'; }
[[nodiscard]] constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
/// White space inside a line; a carriage return counts, so that it never shows at the end of one.
[[nodiscard]] constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}
[[nodiscard]] constexpr bool is_white(char c) { return is_blank(c) || c == '\n'; }

[[nodiscard]] constexpr std::string_view without_blanks_around(std::string_view text) {
  while (!text.empty() && is_white(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_white(text.back())) text.remove_suffix(1);
  return text;
}

}  // namespace rigor
