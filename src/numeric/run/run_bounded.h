// SPDX-License-Identifier: GPL-3.0-or-later
// A double with a bound of its error, as a number of programs. The formulas are in `bounds.h`.
#pragma once

#include <limits>

#include "numeric/run/run_numbers.h"

namespace rigor {

struct Bounded {
  double value = 0.0;
  double bound = 0.0;

  Bounded() = default;
  explicit Bounded(double exact) : value(exact), bound(std::isfinite(exact) ? 0.0 : infinity) {}
  /// Rounded upwards; nothing is known of what is not finite.
  Bounded(double rounded, double error) : value(rounded), bound(error * (1.0 + 8.0 * unit)) {
    if (!std::isfinite(value) || !(bound < infinity)) bound = infinity;
  }

  static constexpr double unit = 0x1p-53;
  static constexpr double least = 0x1p-1074;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  [[nodiscard]] static double rounding(double value) { return unit * std::abs(value) + least; }
};

[[nodiscard]] inline Bounded operator-(const Bounded& x) {
  Bounded result;
  result.value = -x.value;
  result.bound = x.bound;
  return result;
}
[[nodiscard]] inline Bounded operator+(const Bounded& x, const Bounded& y) {
  const double value = x.value + y.value;
  return {value, x.bound + y.bound + Bounded::rounding(value)};
}
[[nodiscard]] inline Bounded operator-(const Bounded& x, const Bounded& y) { return x + -y; }
[[nodiscard]] inline Bounded operator*(const Bounded& x, const Bounded& y) {
  const double value = x.value * y.value;
  const double carried =
      std::abs(x.value) * y.bound + std::abs(y.value) * x.bound + x.bound * y.bound + 3 * Bounded::least;
  return {value, carried + Bounded::rounding(value)};
}
[[nodiscard]] inline Bounded operator/(const Bounded& x, const Bounded& y) {
  const double value = x.value / y.value;
  const double nearest = std::abs(y.value) * (1.0 - Bounded::unit) - y.bound;
  if (!(nearest > 0.0)) return {value, Bounded::infinity};
  const double carried = (x.bound + std::abs(value) * y.bound + 3 * Bounded::least) / nearest;
  return {value, carried * (1.0 + 4.0 * Bounded::unit) + Bounded::rounding(value)};
}

template <>
struct NumberTraits<Bounded> {
  static constexpr bool has_lanes = false;
  static Bounded root(const Bounded& x) {
    const double value = std::sqrt(x.value);
    if (x.value < 0.0 || x.bound == 0.0) return {value, Bounded::rounding(value)};
    const double lowest = x.value - x.bound;
    // From 0 to √(x + d), at most √d away from √x in either direction when d ≥ x.
    if (!(lowest > 0.0)) return {value, std::sqrt(x.value + x.bound) + Bounded::rounding(value)};
    return {value, x.bound / (value + std::sqrt(lowest)) + Bounded::rounding(value)};
  }
  static Bounded absolute(const Bounded& x) { return x.value < 0.0 ? -x : x; }
  static Bounded sine(const Bounded& x) { return {std::sin(x.value), x.bound + 4.0 * Bounded::unit}; }
  static Bounded cosine(const Bounded& x) { return {std::cos(x.value), x.bound + 4.0 * Bounded::unit}; }
  static Bounded exponential(const Bounded& x) {
    const double value = std::exp(x.value);
    if (value <
        std::numeric_limits<double>::min()) {  // too few bits, or none, to multiply: at most e^(x + d)
      const double largest = std::exp(std::nextafter(x.value + x.bound, Bounded::infinity));
      return {value, largest * (1.0 + 8.0 * Bounded::unit) + 2.0 * Bounded::least};
    }
    return {value, value * (std::expm1(x.bound) + 8.0 * Bounded::unit) * (1.0 + 8.0 * Bounded::unit) +
                       2.0 * Bounded::least};
  }
  static Bounded tangent(const Bounded& x) { return sine(x) / cosine(x); }
  static Bounded hyperbolic_sine(const Bounded& x) {
    return half(exponential(x) - exponential(-x), std::sinh(x.value));
  }
  static Bounded hyperbolic_cosine(const Bounded& x) {
    return half(exponential(x) + exponential(-x), std::cosh(x.value));
  }
  static Bounded hyperbolic_tangent(const Bounded& x) {
    return {std::tanh(x.value), x.bound + 4.0 * Bounded::unit};
  }
  static Bounded read(const std::string& digits) {
    const double value = NumberTraits<double>::read(digits);
    return {value, Bounded::rounding(value)};
  }

 private:
  /// Half of `twice`, for which a library's `value` is taken: what is known of one is known of the other.
  static Bounded half(const Bounded& twice, double value) {
    return {value, twice.bound / 2 + std::abs(twice.value / 2 - value) + 2.0 * Bounded::least};
  }
};

}  // namespace rigor
