// SPDX-License-Identifier: GPL-3.0-or-later
#include "source/latin1.h"

#include <fmt/format.h>
#include <utf8.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string_view>

namespace rigor {
namespace {

constexpr std::string_view unsaid_sign = "\x1A";
constexpr std::string_view signs_of_mathematics = "\xAC\xB0\xB1\xB2\xB3\xB5\xB7\xB9\xBC\xBD\xBE\xD7\xF7";

/// What `\usepackage[…]{inputenc}` says about the text.
enum class Encoding : std::uint8_t { unsaid, latin1, other };

Encoding said_encoding(std::string_view text) {
  const std::size_t package = text.find("]{inputenc}");
  if (package == std::string_view::npos) return Encoding::unsaid;
  const std::size_t open = text.rfind('[', package);
  if (open == std::string_view::npos) return Encoding::unsaid;
  const std::string_view option = text.substr(open + 1, package - open - 1);
  for (const std::string_view name : {"latin1", "latin9", "ansinew", "cp1252"}) {
    if (option == name) return Encoding::latin1;
  }
  return Encoding::other;
}

/// The code point of a byte above ASCII; nothing for what neither alphabet has.
std::optional<char32_t> code_point_of(unsigned char byte) {
  if (byte == 0xA0U) return U' ';
  if (byte > 0xA0U) return byte;
  switch (byte) {
    case 0x80U:
      return U'€';
    case 0x82U:
      return U'‚';
    case 0x84U:
      return U'„';
    case 0x85U:
      return U'…';
    case 0x91U:
      return U'‘';
    case 0x92U:
      return U'’';
    case 0x93U:
      return U'“';
    case 0x94U:
      return U'”';
    case 0x96U:
      return U'–';
    case 0x97U:
      return U'—';
    default:
      return std::nullopt;
  }
}

bool is_high(char byte) { return static_cast<unsigned char>(byte) >= 0x80U; }

/// Is a letter of several bytes there? Hardly a text in Latin-1 has one by chance.
bool holds_utf8(const std::string& text) {
  for (auto at = std::ranges::find_if(text, is_high); at != text.end();
       at = std::find_if(at + 1, text.end(), is_high)) {
    if (utf8::find_invalid(at, text.end()) != at) return true;
  }
  return false;
}

}  // namespace

Diagnostics decode_latin1(std::string& text, FileId file) {
  const auto first = utf8::find_invalid(text.begin(), text.end());
  if (first == text.end()) return {};
  const Encoding said = said_encoding(text);
  const bool known = std::ranges::all_of(
      text, [](char c) { return !is_high(c) || code_point_of(static_cast<unsigned char>(c)); });
  const bool guessed =
      said == Encoding::unsaid && text.find('\xFF') == std::string::npos && !holds_utf8(text);
  if (!known || text.find('\0') != std::string::npos || !(said == Encoding::latin1 || guessed)) return {};
  const unsigned value = static_cast<unsigned char>(*first);
  const char* const where = &*first;
  std::uint32_t offset = 0;
  std::string decoded;
  decoded.reserve(text.size() + text.size() / 8);
  for (const char& c : text) {
    if (&c == where) offset = static_cast<std::uint32_t>(decoded.size());
    if (!is_high(c)) {
      decoded += c;
    } else if (said != Encoding::latin1 && signs_of_mathematics.find(c) != std::string_view::npos) {
      decoded += unsaid_sign;
    } else {
      utf8::append(*code_point_of(static_cast<unsigned char>(c)), std::back_inserter(decoded));
    }
  }
  text = std::move(decoded);
  return {{DiagnosticKind::read_as_latin1,
           {file, offset, offset + 1},
           fmt::format("byte `0x{:02X}` is not UTF-8; the text is read as Latin-1", value),
           {},
           {"save the file as UTF-8"}}};
}

}  // namespace rigor
