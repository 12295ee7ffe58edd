// SPDX-License-Identifier: GPL-3.0-or-later
// A physical dimension: the exponents of the seven base quantities of the SI. Products add them.
#pragma once

#include <array>
#include <string>

#include "base/small_rational.h"

namespace rigor {

/// Mass, length, time, electric current, temperature, amount of substance, luminous intensity.
enum class BaseQuantity : std::uint8_t { mass, length, time, current, temperature, amount, intensity };
inline constexpr std::size_t base_quantity_count = 7;

class Dimension {
 public:
  Dimension() = default;  // of a pure number
  explicit Dimension(const std::array<SmallRational, base_quantity_count>& exponents)
      : exponents_(exponents) {}
  static Dimension of(BaseQuantity quantity);

  [[nodiscard]] const std::array<SmallRational, base_quantity_count>& exponents() const { return exponents_; }
  [[nodiscard]] bool is_none() const { return *this == Dimension(); }
  [[nodiscard]] bool is_valid() const;  // every exponent fits into its type

  Dimension& operator+=(const Dimension& other);
  friend Dimension operator+(Dimension a, const Dimension& b) { return a += b; }
  friend Dimension operator-(Dimension a, const Dimension& b) { return a += b * SmallRational(-1); }
  friend Dimension operator*(Dimension a, const SmallRational& factor);
  friend bool operator==(const Dimension&, const Dimension&) = default;

  /// `M L^2 T^{-2}`, and `1` for a pure number.
  [[nodiscard]] std::string text() const;

 private:
  std::array<SmallRational, base_quantity_count> exponents_{};
};

/// `L^2`, `L`, or nothing, as a factor.
[[nodiscard]] std::string power_text(const std::string& base, const SmallRational& exponent);

}  // namespace rigor
