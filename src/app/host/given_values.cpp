// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/host/given_values.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>

#include "base/ascii.h"

namespace rigor {
namespace {

/// At commas outside of brackets, which a name such as `I_{1,2}` has as well.
std::vector<std::string_view> split_at_commas(std::string_view text) {
  std::vector<std::string_view> parts;
  int depth = 0;
  std::size_t begin = 0;
  for (std::size_t k = 0; k <= text.size(); ++k) {
    const char c = k < text.size() ? text[k] : ',';
    depth += c == '(' || c == '{' ? 1 : c == ')' || c == '}' ? -1 : 0;
    if (c != ',' || (depth != 0 && k < text.size())) continue;
    parts.push_back(without_blanks_around(text.substr(begin, k - begin)));
    begin = k + 1;
  }
  return parts;
}

std::optional<double> number_in(std::string_view text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<std::vector<double>> numbers_in(std::string_view text) {
  const bool in_brackets = text.size() > 1 && text.front() == '(' && text.back() == ')';
  std::vector<double> numbers;
  for (const std::string_view part : split_at_commas(in_brackets ? text.substr(1, text.size() - 2) : text)) {
    const auto number = number_in(part);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace

Result<std::map<std::string, std::vector<double>>> read_given_values(std::string_view text) {
  std::map<std::string, std::vector<double>> values;
  for (const std::string_view part : split_at_commas(text)) {
    const auto equals = part.find('=');
    const std::string_view name = without_blanks_around(part.substr(0, equals));
    const auto numbers = equals == std::string_view::npos
                             ? std::nullopt
                             : numbers_in(without_blanks_around(part.substr(equals + 1)));
    if (name.empty() || !numbers) return refuse(fmt::format("`{}` gives no letter a number", part));
    values[std::string(name)] = *numbers;
  }
  return values;
}

}  // namespace rigor
