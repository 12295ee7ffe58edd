// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/file/quantity_text.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

#include "latex/unit/units.h"

namespace rigor {
namespace {

/// What SI units are not, and notes use.
struct OtherUnit {
  std::string_view sign;
  std::array<int, 3> exponents;  // kg, m, s
  double factor;
};

constexpr double degree = std::numbers::pi / 180;
constexpr auto other_units = std::to_array<OtherUnit>({
    {"deg", {0, 0, 0}, degree},
    {"°", {0, 0, 0}, degree},
    {"deg/s", {0, 0, -1}, degree},
    {"°/s", {0, 0, -1}, degree},
    {"rpm", {0, 0, -1}, std::numbers::pi / 30},
    {"u", {1, 0, 0}, 1.66053906892e-27},  // CODATA 2022
    {"Å", {0, 1, 0}, 1e-10},
});

bool is_number_sign(char c) { return (c >= '0' && c <= '9') || c == '.' || c == '+' || c == '-'; }

/// The length of the decimal number that the text starts with.
std::size_t number_length(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size() && is_number_sign(text[at])) ++at;
  if (at == 0 || at >= text.size() || (text[at] != 'e' && text[at] != 'E')) return at;
  std::size_t behind = at + 1;
  if (behind < text.size() && (text[behind] == '+' || text[behind] == '-')) ++behind;
  const std::size_t digits = behind;
  while (behind < text.size() && text[behind] >= '0' && text[behind] <= '9') ++behind;
  return behind > digits ? behind : at;
}

/// The double nearest to `digits` · 10^ten, or nothing where `digits` is no finite decimal number.
std::optional<double> scaled(std::string_view digits, int ten) {
  if (digits.starts_with('+')) digits.remove_prefix(1);
  double value = 0;
  const auto whole = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (whole.ec != std::errc() || whole.ptr != digits.data() + digits.size() || !std::isfinite(value))
    return std::nullopt;
  if (ten == 0) return value;
  const auto e = digits.find_first_of("eE");
  int own = 0;
  if (e != std::string_view::npos) {
    const std::size_t begin = e + (digits.substr(e + 1).starts_with('+') ? 2 : 1);
    if (std::from_chars(digits.data() + begin, digits.data() + digits.size(), own).ec != std::errc())
      return std::nullopt;
  }
  const std::string text = fmt::format("{}e{}", digits.substr(0, e), static_cast<std::int64_t>(own) + ten);
  if (std::from_chars(text.data(), text.data() + text.size(), value).ec != std::errc()) return std::nullopt;
  return value;
}

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ') || text.starts_with('\t')) text.remove_prefix(1);
  while (text.ends_with(' ') || text.ends_with('\t')) text.remove_suffix(1);
  return text;
}

Dimension dimension_of(int mass, int length, int time) {
  return Dimension::of(BaseQuantity::mass) * SmallRational(mass) +
         Dimension::of(BaseQuantity::length) * SmallRational(length) +
         Dimension::of(BaseQuantity::time) * SmallRational(time);
}

Result<QuantityText> with_unit(std::string_view whole, std::string_view digits, std::string_view unit_text) {
  const auto no_number = [&] {
    return refuse(fmt::format("`{}` does not begin with a finite number", whole));
  };
  for (const OtherUnit& other : other_units) {
    if (unit_text != other.sign) continue;
    const auto value = scaled(digits, 0);
    if (!value) return no_number();
    return QuantityText{*value * other.factor,
                        dimension_of(other.exponents[0], other.exponents[1], other.exponents[2])};
  }
  std::string problem;
  const auto unit = unit_text.empty() ? WrittenUnit{} : read_unit(unit_text, UnitNames::units, &problem);
  const auto value = scaled(digits, unit ? unit->ten : 0);
  if (!value) return no_number();
  if (!unit) return refuse(fmt::format("the unit of `{}` is not read: {}", whole, problem));
  const double si =
      *value * static_cast<double>(unit->factor.over()) / static_cast<double>(unit->factor.under());
  if (!std::isfinite(si)) return no_number();
  return QuantityText{si, Dimension(unit->exponents)};
}

}  // namespace

Result<QuantityText> read_quantity(std::string_view text) {
  const std::string_view whole = trimmed(text);
  const std::size_t length = number_length(whole);
  return with_unit(whole, whole.substr(0, length), trimmed(whole.substr(length)));
}

std::string name_of(const Dimension& dimension) {
  const std::array<std::pair<Dimension, std::string_view>, 6> names{{
      {Dimension(), "a pure number"},
      {mass_dimension(), "a mass (M)"},
      {length_dimension(), "a length (L)"},
      {time_dimension(), "a time (T)"},
      {rate_dimension(), "a rate (T^{-1})"},
      {density_dimension(), "a density (M L^{-3})"},
  }};
  for (const auto& [known, name] : names) {
    if (known == dimension) return std::string(name);
  }
  return fmt::format("a quantity of dimension {}", dimension.text());
}

Dimension mass_dimension() { return dimension_of(1, 0, 0); }
Dimension length_dimension() { return dimension_of(0, 1, 0); }
Dimension time_dimension() { return dimension_of(0, 0, 1); }
Dimension rate_dimension() { return dimension_of(0, 0, -1); }
Dimension density_dimension() { return dimension_of(1, -3, 0); }
Dimension inertia_dimension() { return dimension_of(1, 2, 0); }

}  // namespace rigor
