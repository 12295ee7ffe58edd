// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/wording/escape.h"

#include <fmt/format.h>

#include "base/utf8.h"

namespace rigor {
namespace {

bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n' && c != '\r';
}

bool is_unreserved(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("-._~/").find(c) != std::string_view::npos;
}

std::string with_percent(std::string_view text, std::string_view escaped) {
  std::string result;
  for (const char c : as_utf8(text)) {
    if (escaped.find(c) != std::string_view::npos) {
      result += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    } else if (is_control(c)) {
      result += replacement_character;
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace

std::string uri_of_path(std::string_view path) {
  std::string uri = path.starts_with('/') ? "file://" : "";
  for (const char c : path)
    uri += is_unreserved(c) ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  return uri;
}

std::string workflow_message(std::string_view text) { return with_percent(text, "%\r\n"); }

std::string workflow_property(std::string_view text) { return with_percent(text, "%\r\n:,"); }

}  // namespace rigor
