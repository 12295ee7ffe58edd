// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/picture/plot_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigor {
namespace {

constexpr double largest_drawn = 1e300;  // on a linear scale: differences must not overflow

/// 1, 2 or 5 times a power of ten: the smallest that is at least `least`.
double round_step(double least) {
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= least * (1 - 1e-9)) return factor * power;
  }
  return 10 * power;
}

std::string power_label(int exponent) {
  if (exponent == 0) return "1";
  if (exponent == 1) return "10";
  return fmt::format("$10^{{{}}}$", exponent);
}

std::vector<Tick> decades(const PlotScale& scale) {
  const int first = static_cast<int>(std::ceil(std::log10(scale.low) - 1e-9));
  const int last = static_cast<int>(std::floor(std::log10(scale.high) + 1e-9));
  const int apart = std::max(1, static_cast<int>(std::ceil((last - first) / 8.0)));
  std::vector<Tick> ticks;
  for (int exponent = first; exponent <= last; ++exponent) {
    const bool named = (exponent % apart) == 0;
    if (apart > 4 && !named) continue;
    ticks.push_back({std::pow(10.0, exponent), named ? power_label(exponent) : std::string()});
  }
  return ticks;
}

/// As many digits as the step has; a common power of ten where numbers would be long.
std::string number_label(double value, double step) {
  if (std::abs(value) < step * 1e-6) return "0";
  const double largest = std::max(std::abs(value), step);
  if (largest >= 1e5 || step < 1e-4) return fmt::format("{:.3g}", value);
  const int digits = std::max(0, static_cast<int>(std::ceil(-std::log10(step) - 1e-9)));
  std::string text = fmt::format("{:.{}f}", value, digits);
  if (text[0] == '-') text.replace(0, 1, "−");
  return text;
}

}  // namespace

double PlotScale::place(double value) const {
  if (!logarithmic) return (value - low) / (high - low);
  return (std::log(value) - std::log(low)) / (std::log(high) - std::log(low));
}

PlotScale fitting_scale(const std::vector<double>& values, bool logarithmic) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double value : values) {
    if (!std::isfinite(value) || (logarithmic && value <= 0)) continue;
    if (!logarithmic && std::abs(value) > largest_drawn) continue;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  if (low > high) return {logarithmic, logarithmic ? 0.1 : 0.0, logarithmic ? 10.0 : 1.0};
  if (logarithmic) {
    const double room = std::max((std::log10(high) - std::log10(low)) * 0.06, 0.15);
    double below = std::max(low * std::pow(10.0, -room), std::numeric_limits<double>::min());
    double above = std::min(high * std::pow(10.0, room), std::numeric_limits<double>::max());
    if (above < below * 10) {  // at least one power of ten shall be seen
      below = std::pow(10.0, std::floor(std::log10(low)));
      above = std::pow(10.0, std::floor(std::log10(high)) + 1);
    }
    return {true, below, above};
  }
  // A line that differs only by rounding is drawn as a constant.
  const double size = std::max(std::abs(low), std::abs(high));
  double room = (high / 2 - low / 2) * 0.12;
  if (high - low < size * 1e-9 || !(room > 0)) room = size > 0 ? size * 0.25 : 1.0;
  return {false, low - room, high + room};
}

std::vector<Tick> ticks_of(const PlotScale& scale) {
  if (scale.logarithmic) return decades(scale);
  const double step = round_step((scale.high - scale.low) / 6);
  std::vector<Tick> ticks;
  if (!std::isfinite(step) || !(step > 0)) return ticks;
  const double first = std::ceil(scale.low / step - 1e-9);
  for (int count = 0; count < 12; ++count) {
    const double value = (first + count) * step;
    if (!(value <= scale.high + step * 1e-9)) break;
    ticks.push_back({value, number_label(value, step)});
  }
  return ticks;
}

}  // namespace rigor
