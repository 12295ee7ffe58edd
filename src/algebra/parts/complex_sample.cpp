// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/parts/complex_sample.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "base/ascii.h"

namespace rigor {
namespace {

/// `2i`, `i`, `(1/2)i` for a positive number.
[[nodiscard]] std::string times_i(const std::string& number) {
  if (number == "1") return "i";
  const bool whole = std::ranges::all_of(number, [](char c) { return is_digit(c); });
  return whole ? number + "i" : "(" + number + ")i";
}

/// The other way round.
[[nodiscard]] std::string without_i(std::string_view text) {
  text.remove_suffix(1);
  if (text.empty()) return "1";
  const bool brackets = text.front() == '(' && text.back() == ')';
  return std::string(brackets ? text.substr(1, text.size() - 2) : text);
}

[[nodiscard]] bool is_imaginary(std::string_view term) { return term.ends_with('i'); }

[[nodiscard]] bool is_in_parts(const SampleValue& value, const RealQuestion& real) {
  const auto symbol = static_cast<std::size_t>(value.symbol);
  return symbol < real.in_parts.size() && real.in_parts[symbol];
}

}  // namespace

std::string complex_text(const std::string& re, const std::string& im) {
  if (im == "0") return re;
  const bool negative = im.starts_with('-');
  const std::string part = times_i(negative ? im.substr(1) : im);
  if (re == "0") return negative ? "-" + part : part;
  return fmt::format("{} {} {}", re, negative ? '-' : '+', part);
}

std::pair<std::string, std::string> parts_of_text(std::string_view text) {
  if (!is_imaginary(text)) return {std::string(text), "0"};
  std::string re = "0";
  std::size_t between = text.rfind(" + ");
  if (between == std::string_view::npos) between = text.rfind(" - ");
  bool negative = text.starts_with('-');
  if (between != std::string_view::npos) {
    re = std::string(text.substr(0, between));
    negative = text[between + 1] == '-';
    text.remove_prefix(between + 3);
  } else if (negative) {
    text.remove_prefix(1);
  }
  return {re, (negative ? "-" : "") + without_i(text)};
}

SampleValue with_complex_values(SampleValue value, const RealQuestion& real) {
  if (!is_in_parts(value, real)) return value;
  const std::size_t count = value.components.size() / 2;
  for (std::size_t k = 0; k < count; ++k)
    value.components[k] = complex_text(value.components[k], value.components[count + k]);
  value.components.resize(count);
  return value;
}

Sample with_complex_values(Sample sample, const RealQuestion& real) {
  for (SampleValue& value : sample.values) value = with_complex_values(std::move(value), real);
  return sample;
}

Sample with_parts(Sample sample, const RealQuestion& real) {
  for (SampleValue& value : sample.values) {
    if (!is_in_parts(value, real)) continue;
    const std::size_t count = value.components.size();
    value.components.resize(2 * count);
    for (std::size_t k = 0; k < count; ++k)
      std::tie(value.components[k], value.components[count + k]) = parts_of_text(value.components[k]);
  }
  return sample;
}

Sample at_part(Sample sample, const RealQuestion& real, std::uint8_t part) {
  const std::size_t free = real.sides.indices.size();
  if (sample.axes.size() >= free)
    sample.axes.insert(sample.axes.begin() + static_cast<std::ptrdiff_t>(free), part);
  return sample;
}

Sample without_part(Sample sample, const RealQuestion& real) {
  const std::size_t free = real.sides.indices.size();
  const bool in_parts = sample.axes.size() > free && real.question.claim.relation == Relation::equal;
  if (real.sides_in_parts && in_parts)
    sample.axes.erase(sample.axes.begin() + static_cast<std::ptrdiff_t>(free));
  return sample;
}

}  // namespace rigor
