// SPDX-License-Identifier: GPL-3.0-or-later
// Classes of bytes, as TeX and Markdown see them; the same in every locale.
#pragma once

#include <string>
#include <string_view>

namespace rigor {

[[nodiscard]] constexpr bool is_small_letter(char c) { return c >= 'a' && c <= 'z'; }
[[nodiscard]] constexpr bool is_capital_letter(char c) { return c >= 'A' && c <= 'Z'; }
[[nodiscard]] constexpr bool is_capital_letter(std::string_view text) {
  return text.size() == 1 && is_capital_letter(text[0]);
}
[[nodiscard]] constexpr bool is_letter(char c) { return is_small_letter(c) || is_capital_letter(c); }
/// In the name of a control word: also `@`, which packages and preambles use.
[[nodiscard]] constexpr bool is_word_letter(char c) { return is_letter(c) || c == '@'; }
[[nodiscard]] constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
[[nodiscard]] constexpr bool is_letter_or_digit(char c) { return is_letter(c) || is_digit(c); }
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

[[nodiscard]] constexpr char lowered(char c) {
  return is_capital_letter(c) ? static_cast<char>(c - 'A' + 'a') : c;
}
/// In small letters; other bytes, those of UTF-8 among them, as they are.
[[nodiscard]] inline std::string lowered(std::string_view text) {
  std::string small(text);
  for (char& c : small) c = lowered(c);
  return small;
}
/// In small letters, and with a blank for each white sign and each tie, so that phrases are found over lines.
[[nodiscard]] inline std::string lowered_line(std::string_view text) {
  std::string small(text);
  for (char& c : small) c = is_white(c) || c == '~' ? ' ' : lowered(c);
  return small;
}

}  // namespace rigor
