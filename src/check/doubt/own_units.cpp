// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/doubt/own_units.h"

#include <algorithm>
#include <array>

#include "base/ascii.h"

namespace rigor {
namespace {

constexpr std::array<std::string_view, 6> faces{"\\mathrm", "\\text", "\\textrm", "\\rm", "\\unit", "\\si"};

/// Without blanks, and a unit's face as `@`: `1@F` of `1\,\text{F}`.
std::string bare(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c != '\\') {
      const bool counts = c != ' ' && c != '\n' && c != '\t' && c != '{' && c != '}' && c != '~';
      if (counts) result += c;
      ++at;
      continue;
    }
    std::size_t end = at + 1;
    while (end < text.size() && is_letter(text[end])) ++end;
    const std::string_view name = text.substr(at, end - at);
    if (std::ranges::find(faces, name) != faces.end()) {
      result += '@';
    } else if (name == "\\times" || name == "\\cdot") {
      result += '*';
    } else if (name == "\\mu") {
      result += 'u';
    } else if (name.size() > 1) {
      result += '?';  // something else
    }
    at = std::max(end, at + 2);
  }
  return result;
}

/// `F` of `1@F` or `10^-15@m`; nothing where other signs stand behind the unit.
std::optional<std::string> unit_alone(std::string_view number_and_unit) {
  const auto at = number_and_unit.find('@');
  if (at == std::string_view::npos || at == 0) return std::nullopt;
  const std::string_view number = number_and_unit.substr(0, at);
  const bool plain = std::ranges::all_of(
      number, [](char c) { return is_digit(c) || c == '.' || c == '*' || c == '^' || c == '-'; });
  std::string unit;
  for (const char c : number_and_unit.substr(at)) {
    if (c == '@') continue;
    if (!is_letter(c)) return std::nullopt;
    unit += c;
  }
  return plain && !unit.empty() ? std::optional(unit) : std::nullopt;
}

}  // namespace

std::optional<std::string> unit_introduced(std::string_view left, std::string_view right) {
  const std::string one = bare(left);
  const std::string other = bare(right);
  auto unit = unit_alone(one);
  if (!unit || !one.starts_with("1@") || other.starts_with("1@") || !unit_alone(other)) return std::nullopt;
  return unit;
}

std::optional<std::string> unit_introduced_in(std::string_view relation) {
  const auto sign = relation.find('=');
  if (sign == std::string_view::npos) return std::nullopt;
  return unit_introduced(relation.substr(0, sign), relation.substr(sign + 1));
}

bool writes_unit(std::string_view text, std::string_view unit) {
  const std::string all = bare(text);
  const std::string sign = "@" + std::string(unit);
  for (auto at = all.find(sign); at != std::string::npos; at = all.find(sign, at + 1)) {
    const std::size_t behind = at + sign.size();
    if (behind == all.size() || !is_letter(all[behind])) return true;
  }
  return false;
}

}  // namespace rigor
