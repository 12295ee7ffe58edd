// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/wording/figures.h"

#include <fmt/format.h>

#include <cmath>

namespace rigor {

std::string short_number(double value) {
  if (std::isnan(value)) return "";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  if (value == 0) return "0";
  const double size = std::abs(value);
  if (size >= 0.1 && size < 9.95) return fmt::format("{:.1f}", value);
  if (size >= 9.95 && size < 9999.5) return fmt::format("{:.0f}", value);
  return fmt::format("{:.1e}", value);
}

std::string value_text(double value) {
  if (std::isnan(value)) return "nan";
  return fmt::format("{:.6g}", value == 0 ? 0.0 : value);
}

std::string value_text(std::span<const double> components) {
  if (components.size() == 1) return value_text(components[0]);
  std::string text = "(";
  for (std::size_t k = 0; k < components.size(); ++k) {
    if (k > 0) text += components.size() > 3 && k % 3 == 0 ? "; " : ", ";
    text += value_text(components[k]);
  }
  return text + ")";
}

}  // namespace rigor
