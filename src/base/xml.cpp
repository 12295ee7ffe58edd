// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/xml.h"

#include <fmt/format.h>

#include <cstdint>

#include "base/utf8.h"

namespace rigor {
namespace {

bool is_no_character(char32_t c) {
  return (c < 0x20 && c != '\t' && c != '\n' && c != '\r') || c == 0xFFFE || c == 0xFFFF;
}

std::string_view entity_of(char32_t c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return "";
  }
}

}  // namespace

std::string xml_escaped(std::string_view text) {
  const std::string valid = as_utf8(text);
  std::string escaped;
  for (std::size_t at = 0; at < valid.size();) {
    const std::size_t begin = at;
    const char32_t c = next_code_point(valid, at);
    if (const std::string_view entity = entity_of(c); !entity.empty()) {
      escaped += entity;
    } else if (is_no_character(c)) {
      escaped += replacement_character;
    } else if (c < 0x20) {
      escaped += fmt::format("&#{};", static_cast<std::uint32_t>(c));
    } else {
      escaped.append(valid, begin, at - begin);
    }
  }
  return escaped;
}

}  // namespace rigor
