// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/constant/number_slip.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "base/ascii.h"

namespace rigor {
namespace {

constexpr double circumference = 6.28318530717958647692;

/// `0.063` is 63.
std::string significant(std::string digits) {
  std::erase(digits, '.');
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size()));
  return digits;
}

double integer_of(const std::string& digits) { return std::strtod(digits.c_str(), nullptr); }

/// Where the right number and the written one, times this factor, agree to the digits.
bool leads_to(const WrittenNumber& number, double factor) {
  const double mantissa = integer_of(significant(number.digits));
  return mantissa > 0 && std::abs(number.ratio / factor - 1) <= 0.5 / mantissa;
}

bool exchanges_two_digits(const WrittenNumber& number) {
  const std::string digits = significant(number.digits);
  for (std::size_t k = 0; k + 1 < digits.size(); ++k) {
    std::string other = digits;
    std::swap(other[k], other[k + 1]);
    if (other != digits && leads_to(number, integer_of(other) / integer_of(digits))) return true;
  }
  return false;
}

std::size_t behind_blanks(std::string_view text, std::size_t at) {
  for (;;) {
    if (text.substr(at).starts_with("\\,")) {
      at += 2;
    } else if (at < text.size() && text[at] == ' ') {
      ++at;
    } else {
      return at;
    }
  }
}

std::optional<int> whole_number(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

/// `\times 10^{-24}` behind a number: its exponent, and where it ends.
std::optional<std::pair<int, std::size_t>> power_behind(std::string_view text, std::size_t at) {
  at = behind_blanks(text, at);
  const std::size_t sign = text.substr(at).starts_with("\\times")  ? 6
                           : text.substr(at).starts_with("\\cdot") ? 5
                                                                   : 0;
  if (sign == 0) return std::nullopt;
  at = behind_blanks(text, at + sign);
  if (!text.substr(at).starts_with("10^")) return std::nullopt;
  at = behind_blanks(text, at + 3);
  const bool braced = at < text.size() && text[at] == '{';
  const std::size_t end = braced ? text.find('}', at) : at + 1;
  if (end == std::string_view::npos || end > text.size()) return std::nullopt;
  const std::string_view inside = braced ? text.substr(at + 1, end - at - 1) : text.substr(at, 1);
  const auto exponent = whole_number(inside);
  if (!exponent) return std::nullopt;
  return std::pair(*exponent, braced ? end + 1 : end);
}

/// Where a number stands in a side.
struct NumberPlace {
  WrittenNumber number;
  std::size_t begin = 0;
  std::size_t end = 0;
  bool has_power = false;
  bool in_macro = false;
};

std::optional<NumberPlace> place_in_macro(std::string_view side, WrittenNumber number) {
  for (const std::string_view macro : {"\\SI{", "\\qty{", "\\num{"}) {
    std::size_t begin = side.find(macro);
    if (begin == std::string_view::npos) continue;
    begin += macro.size();
    const std::size_t end = side.find('}', begin);
    if (end == std::string_view::npos) return std::nullopt;
    if (side.substr(begin).starts_with('-')) ++begin;
    const std::string_view inside = side.substr(begin, end - begin);
    const std::size_t e = inside.find_first_of("eE");
    const bool power = e != std::string_view::npos;
    number.digits = std::string(inside.substr(0, e));
    number.ten = power ? whole_number(inside.substr(e + 1)).value_or(0) : 0;
    return NumberPlace{number, begin, end, power, true};
  }
  return std::nullopt;
}

std::optional<NumberPlace> place_of(std::string_view side, WrittenNumber number) {
  if (auto place = place_in_macro(side, number)) return place;
  const std::size_t begin = side.find(number.digits);
  if (begin == std::string_view::npos) return std::nullopt;
  const std::size_t behind = begin + number.digits.size();
  const auto power = power_behind(side, behind);
  number.ten = power ? power->first : 0;
  return NumberPlace{number, begin, power ? power->second : behind, power.has_value(), false};
}

/// The right number to as many digits, with a power of ten where one is written or needed.
std::string right_number(const WrittenNumber& number, bool has_power, bool in_macro) {
  const int places = std::max(static_cast<int>(significant(number.digits).size()) - 1, 0);
  const double value = integer_of(number.digits) * number.ratio;
  const int own = static_cast<int>(std::floor(std::log10(std::abs(value))));
  constexpr int largest_without_power = 4;
  const bool plain = !has_power && own >= -2 && own <= std::max(places, largest_without_power);
  if (plain) return fmt::format("{:.{}f}", value, std::max(places - own, 0));
  const std::string mantissa = fmt::format("{:.{}f}", value * std::pow(10.0, -own), places);
  return in_macro ? fmt::format("{}e{}", mantissa, own + number.ten)
                  : fmt::format("{}\\times10^{{{}}}", mantissa, own + number.ten);
}

}  // namespace

std::optional<std::string> slip_of(const WrittenNumber& number) {
  for (int power = 1; power <= 3; ++power) {
    if (leads_to(number, std::pow(10.0, power)) || leads_to(number, std::pow(10.0, -power)))
      return "the power of ten is another one";
  }
  if (number.ten != 0 && leads_to(number, std::pow(10.0, -2 * number.ten)))
    return "the exponent has the other sign";
  static const std::array<std::pair<double, std::string_view>, 5> factors{
      {{2, "2"}, {circumference, "2π"}, {circumference / 2, "π"}, {4, "4"}, {2 * circumference, "4π"}}};
  for (const auto& [factor, name] : factors) {
    if (leads_to(number, factor) || leads_to(number, 1 / factor))
      return fmt::format("it differs by a factor of {}", name);
  }
  if (exchanges_two_digits(number)) return std::string(exchanged_digits);
  return std::nullopt;
}

WrittenNumber number_in(std::string_view side, const WrittenNumber& number) {
  const auto place = place_of(side, number);
  return place ? place->number : number;
}

std::optional<std::string> with_right_number(std::string_view side, const WrittenNumber& number) {
  const auto place = place_of(side, number);
  if (!place) return std::nullopt;
  return fmt::format("{}{}{}", side.substr(0, place->begin),
                     right_number(place->number, place->has_power, place->in_macro), side.substr(place->end));
}

}  // namespace rigor
