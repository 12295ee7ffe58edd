// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/utf8.h"

#include <utf8.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace rigor {
namespace {

struct Range {
  char32_t first;
  char32_t last;
};

constexpr std::array<Range, 7> combining{{{0x0300, 0x036F},
                                          {0x1AB0, 0x1AFF},
                                          {0x1DC0, 0x1DFF},
                                          {0x200B, 0x200D},
                                          {0x20D0, 0x20FF},
                                          {0xFE00, 0xFE0F},
                                          {0xFE20, 0xFE2F}}};

constexpr std::array<Range, 9> wide{{{0x1100, 0x115F},
                                     {0x2E80, 0xA4CF},
                                     {0xAC00, 0xD7A3},
                                     {0xF900, 0xFAFF},
                                     {0xFE30, 0xFE6F},
                                     {0xFF00, 0xFF60},
                                     {0xFFE0, 0xFFE6},
                                     {0x1F300, 0x1FAFF},
                                     {0x20000, 0x3FFFD}}};

constexpr std::array<Range, 5> steering{
    {{0x00, 0x1F}, {0x7F, 0x9F}, {0x200E, 0x200F}, {0x202A, 0x202E}, {0x2066, 0x2069}}};

template <std::size_t N>
bool is_in(const std::array<Range, N>& ranges, char32_t c) {
  return std::ranges::any_of(ranges, [c](Range r) { return r.first <= c && c <= r.last; });
}

/// What to print for the code point that is at [begin, end) of the text.
std::string_view printed(std::string_view text, std::size_t begin, std::size_t end, char32_t c) {
  if (c == U'\t' || c == U'\n' || c == U'\r') return " ";
  if (is_in(steering, c) || c == U'?') return "?";
  return text.substr(begin, end - begin);
}

}  // namespace

std::string as_utf8(std::string_view bytes) {
  std::string text;
  utf8::replace_invalid(bytes.begin(), bytes.end(), std::back_inserter(text), 0xFFFD);
  return text;
}

std::size_t count_code_points(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char byte) { return !is_continuation(byte); }));
}

char32_t next_code_point(std::string_view text, std::size_t& offset) {
  const auto first = static_cast<unsigned char>(text[offset]);
  if (first < 0x80U) {
    ++offset;
    return first;
  }
  const char* place = text.data() + offset;
  try {
    const char32_t c = utf8::next(place, text.data() + text.size());
    offset = static_cast<std::size_t>(place - text.data());
    return c;
  } catch (const utf8::exception&) {
    ++offset;
    return U'?';
  }
}

std::uint32_t cells(char32_t code_point) {
  if (code_point < 0x300) return 1;
  if (is_in(combining, code_point)) return 0;
  return is_in(wide, code_point) ? 2 : 1;
}

std::size_t cells(std::string_view text) {
  std::size_t sum = 0;
  for (std::size_t offset = 0; offset < text.size();) sum += cells(next_code_point(text, offset));
  return sum;
}

std::string printable(std::string_view text) {
  std::string result;
  result.reserve(text.size());
  for (std::size_t offset = 0; offset < text.size();) {
    const std::size_t begin = offset;
    const char32_t c = next_code_point(text, offset);
    result += printed(text, begin, offset, c);
  }
  return result;
}

std::string shorten(std::string_view text, std::size_t width) {
  std::string result;
  std::size_t used = 0;
  std::size_t room_for_dots = 0;  // bytes of `result` that leave a cell for `…`
  for (std::size_t offset = 0; offset < text.size();) {
    const std::size_t begin = offset;
    const char32_t c = next_code_point(text, offset);
    used += cells(c);
    if (used > width) {
      result.resize(room_for_dots);
      return width == 0 ? result : result + "…";
    }
    result += printed(text, begin, offset, c);
    if (used < width) room_for_dots = result.size();
  }
  return result;
}

}  // namespace rigor
