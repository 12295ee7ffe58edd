// SPDX-License-Identifier: GPL-3.0-or-later
#include "expr/tree/dimension.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace rigor {
namespace {

constexpr std::array<std::string_view, base_quantity_count> letters{"M", "L", "T", "A", "K", "mol", "cd"};

}  // namespace

Dimension Dimension::of(BaseQuantity quantity) {
  Dimension dimension;
  dimension.exponents_[static_cast<std::size_t>(quantity)] = 1;
  return dimension;
}

bool Dimension::is_valid() const { return std::ranges::all_of(exponents_, &SmallRational::is_valid); }

Dimension& Dimension::operator+=(const Dimension& other) {
  for (std::size_t k = 0; k < base_quantity_count; ++k) exponents_[k] = exponents_[k] + other.exponents_[k];
  return *this;
}

Dimension operator*(Dimension a, const SmallRational& factor) {
  for (SmallRational& exponent : a.exponents_) exponent = exponent * factor;
  return a;
}

std::string Dimension::text() const {
  std::string text;
  for (std::size_t k = 0; k < base_quantity_count; ++k) {
    if (exponents_[k].is_zero()) continue;
    text += (text.empty() ? "" : " ") + power_text(std::string(letters[k]), exponents_[k]);
  }
  return text.empty() ? "1" : text;
}

std::string power_text(const std::string& base, const SmallRational& exponent) {
  if (exponent == SmallRational(1)) return base;
  const std::string digits = exponent.text();
  return digits.size() == 1 ? fmt::format("{}^{}", base, digits) : fmt::format("{}^{{{}}}", base, digits);
}

}  // namespace rigor
