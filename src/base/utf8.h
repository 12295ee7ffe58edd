// SPDX-License-Identifier: GPL-3.0-or-later
// Text as code points and as cells of a terminal. Nothing here fails: a byte that is not UTF-8 is one `?`
// (U+FFFD in `as_utf8`).
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace rigor {

/// Is this byte inside a code point, that is, not its first byte?
[[nodiscard]] constexpr bool is_continuation(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

/// Bytes that start a code point; for valid UTF-8, the number of code points. Cost: linear.
[[nodiscard]] std::size_t count_code_points(std::string_view text);

/// The code point at `offset` (below text.size()), which moves past it. A byte that is not UTF-8 gives `?`.
[[nodiscard]] char32_t next_code_point(std::string_view text, std::size_t& offset);

inline constexpr std::string_view replacement_character = "\xEF\xBF\xBD";  // U+FFFD
/// The same text with U+FFFD for what is not UTF-8.
[[nodiscard]] std::string as_utf8(std::string_view bytes);

/// Cells of a terminal: 0 for a combining mark, 2 for a wide (East Asian or emoji) character, else 1.
[[nodiscard]] std::uint32_t cells(char32_t code_point);
[[nodiscard]] std::size_t cells(std::string_view text);

/// The text on one line and without what could steer a terminal: line breaks and tabs become blanks; other
/// control characters, marks that reverse the direction of writing and bytes that are not UTF-8 become `?`.
[[nodiscard]] std::string printable(std::string_view text);

/// A printable text of at most `width` cells; the last is `…` where something was cut off. Cost: O(width).
[[nodiscard]] std::string shorten(std::string_view text, std::size_t width);

}  // namespace rigor
