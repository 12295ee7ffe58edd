// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/cloud_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "numeric/body.h"
#include "numeric/mesh_words.h"

namespace rigor {
namespace {

bool is_separator(char c) { return c == ' ' || c == '\t' || c == '\r' || c == ','; }

/// Blanks with at most one comma among them; nothing where there are two.
std::optional<const char*> after_separators(const char* at, const char* end) {
  bool has_comma = false;
  for (; at != end && is_separator(*at); ++at) {
    if (*at != ',') continue;
    if (has_comma) return std::nullopt;
    has_comma = true;
  }
  return at;
}

std::string_view word_at(const char* at, const char* end) {
  return {at, static_cast<std::size_t>(std::find_if(at, end, is_separator) - at)};
}

/// The numbers of one line without its comment: none or four.
Result<std::optional<std::array<double, 4>>> parse_line(std::string_view line) {
  line = line.substr(0, line.find('#'));
  const char* const end = line.data() + line.size();
  const char* at = line.data();
  std::array<double, 4> numbers{};
  std::size_t count = 0;
  while (at != end && is_separator(*at) && *at != ',') ++at;
  while (at != end) {
    if (count == numbers.size())
      return tl::unexpected(Error{"more than the 4 numbers x, y, z and m are on the line"});
    if (*at == ',') return tl::unexpected(Error{"there is no number before a comma"});
    const char* const digits = at + (*at == '+' ? 1 : 0);
    const auto [next, error] = std::from_chars(digits, end, numbers[count]);
    if (error != std::errc() || (next != end && !is_separator(*next)) || !std::isfinite(numbers[count]))
      return tl::unexpected(Error{fmt::format("`{}` is no finite number", shown(word_at(at, end)))});
    ++count;
    const auto after = after_separators(next, end);
    if (!after) return tl::unexpected(Error{"there is no number between two commas"});
    at = *after;
  }
  if (count == 0) return std::nullopt;
  if (count < numbers.size())
    return tl::unexpected(Error{fmt::format("the line has {} of the 4 numbers x, y, z and m", count)});
  return numbers;
}

}  // namespace

Result<std::array<std::vector<double>, 4>> parse_cloud(std::string_view text) {
  std::array<std::vector<double>, 4> columns;
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    const auto numbers = parse_line(text.substr(0, length));
    if (!numbers) return tl::unexpected(Error{fmt::format("line {}: {}", line, numbers.error().reason)});
    if (*numbers) {
      if (columns[0].size() == most_particles)
        return tl::unexpected(
            Error{fmt::format("line {}: there are more than {} points", line, most_particles)});
      for (std::size_t i = 0; i < 4; ++i) columns[i].push_back((**numbers)[i]);
    }
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  return columns;
}

}  // namespace rigor
