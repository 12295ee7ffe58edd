// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/escape.h"

#include <fmt/format.h>
#include <utf8.h>

#include <iterator>

#include "base/utf8.h"

namespace rigor {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD

/// Neither allowed in XML 1.0 nor of any use elsewhere.
bool is_no_character(char32_t c) {
  return (c < 0x20 && c != '\t' && c != '\n' && c != '\r') || c == 0xFFFE || c == 0xFFFF;
}

bool is_unreserved(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("-._~/").find(c) != std::string_view::npos;
}

std::string with_percent(std::string_view text, std::string_view escaped) {
  std::string result;
  for (const char c : as_utf8(text)) {
    if (escaped.find(c) != std::string_view::npos)
      result += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    else
      result += is_no_character(static_cast<unsigned char>(c)) ? std::string(replacement) : std::string(1, c);
  }
  return result;
}

}  // namespace

std::string as_utf8(std::string_view bytes) {
  std::string text;
  utf8::replace_invalid(bytes.begin(), bytes.end(), std::back_inserter(text), 0xFFFD);
  return text;
}

std::string xml_text(std::string_view text) {
  const std::string valid = as_utf8(text);
  std::string escaped;
  for (std::size_t at = 0; at < valid.size();) {
    const std::size_t begin = at;
    const char32_t c = next_code_point(valid, at);
    if (is_no_character(c))
      escaped += replacement;
    else if (c < 0x20 ||
             (c < 0x80 && std::string_view("&<>\"'").find(static_cast<char>(c)) != std::string_view::npos))
      escaped += fmt::format("&#{};", static_cast<std::uint32_t>(c));
    else
      escaped.append(valid, begin, at - begin);
  }
  return escaped;
}

std::string uri_of_path(std::string_view path) {
  std::string uri = path.starts_with('/') ? "file://" : "";
  for (const char c : path)
    uri += is_unreserved(c) ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  return uri;
}

std::string workflow_message(std::string_view text) { return with_percent(text, "%\r\n"); }

std::string workflow_property(std::string_view text) { return with_percent(text, "%\r\n:,"); }

}  // namespace rigor
