// SPDX-License-Identifier: GPL-3.0-or-later
#include "numeric/mesh/cloud_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "numeric/body/body.h"
#include "numeric/mesh/mesh_words.h"

namespace rigor {
namespace {

bool is_separator(char c) { return c == ' ' || c == '\t' || c == '\r' || c == ','; }

const char* after_separators(const char* at, const char* end) {
  return std::find_if_not(at, end, is_separator);
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
    if (count == numbers.size()) return refuse("more than the 4 numbers x, y, z and m are on the line");
    if (*at == ',') return refuse("there is no number before a comma");
    const std::string_view word = word_at(at, end);
    const auto number = finite_number(word);
    if (!number) return refuse(fmt::format("`{}` is not a finite number", shown(word)));
    numbers[count++] = *number;
    const char* const after = after_separators(at + word.size(), end);
    const auto commas = std::count(at + word.size(), after, ',');
    if (commas > 1) return refuse("there is no number between two commas");
    if (commas == 1 && after == end) return refuse("there is no number after the last comma");
    at = after;
  }
  if (count == 0) return std::nullopt;
  if (count < numbers.size())
    return refuse(fmt::format("the line has {} of the 4 numbers x, y, z and m", count));
  return numbers;
}

}  // namespace

Result<std::array<std::vector<double>, 4>> parse_cloud(
    std::string_view text, const std::function<void(std::size_t, std::size_t)>& parsed) {
  constexpr std::size_t large = 1 << 22;
  const std::size_t size = text.size();
  std::size_t told = 0;
  std::array<std::vector<double>, 4> columns;
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    const auto numbers = parse_line(text.substr(0, length));
    if (!numbers) return refuse(fmt::format("line {}: {}", line, numbers.error().reason));
    if (*numbers) {
      if (columns[0].size() == most_particles)
        return tl::unexpected(
            Error{fmt::format("line {}: there are more than {} points", line, most_particles)});
      for (std::size_t i = 0; i < 4; ++i) columns[i].push_back((**numbers)[i]);
    }
    text.remove_prefix(std::min(length + 1, text.size()));
    const std::size_t done = size - text.size();
    if (!parsed || done - told < large) continue;
    parsed(told, done - told);
    told = done;
  }
  return columns;
}

}  // namespace rigor
