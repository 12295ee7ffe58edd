// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/file/toml_scan.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/utf8.h"

namespace rigor {
namespace {

constexpr std::size_t most_dots = 64;

/// After the string that starts at `at`; a string of one line ends with it, closed or not.
std::size_t end_of_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const bool is_long = text.substr(at).starts_with(std::string(3, quote));
  const std::string end(is_long ? 3 : 1, quote);
  for (at += end.size(); at < text.size(); ++at) {
    if (!is_long && text[at] == '\n') return at;
    if (quote == '"' && text[at] == '\\') {
      ++at;
    } else if (text.substr(at).starts_with(end)) {
      at += end.size();
      for (int k = 0; k < 2 && is_long && at < text.size() && text[at] == quote; ++k) ++at;
      return at;
    }
  }
  return text.size();
}

}  // namespace

std::optional<TomlFlaw> find_toml_flaw(std::string_view text) {
  constexpr std::string_view between_keys = "=,[]{}\n";
  std::size_t dots = 0;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '#') {
      at = std::min(text.find('\n', at), text.size());
      continue;
    }
    if (c == '"' || c == '\'') {
      at = end_of_string(text, at);
      continue;
    }
    if (static_cast<unsigned char>(c) >= 0x80) {
      std::size_t end = at;
      static_cast<void>(next_code_point(text, end));
      return TomlFlaw{at, end,
                      fmt::format("`{}` can only stand in a string or a comment", text.substr(at, end - at))};
    }
    if (between_keys.find(c) != std::string_view::npos) dots = 0;
    if (c == '.' && ++dots > most_dots) return TomlFlaw{at, at + 1, "tables are nested too deep"};
    ++at;
  }
  return std::nullopt;
}

}  // namespace rigor
