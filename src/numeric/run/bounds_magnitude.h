// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes of errors: m 2^e with 64 bits for e, so that no bound overflows or vanishes. Every operation rounds
// upwards, by 2^-49 at most.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace rigor {

class Magnitude {
 public:
  Magnitude() = default;
  /// `m` is not negative.
  explicit Magnitude(double m, std::int64_t exponent = 0) : m_(m * (1.0 + 0x1p-50)), exponent_(exponent) {
    if (m_ == 0.0 || !(m_ < std::numeric_limits<double>::infinity())) {
      exponent_ = 0;
      if (m_ != 0.0) *this = infinite();
    } else if (m_ < 1.0 || m_ >= 2.0) {
      int shift = 0;
      m_ = 2.0 * std::frexp(m_, &shift);
      exponent_ += shift - 1;
    }
  }
  [[nodiscard]] static Magnitude infinite() {
    Magnitude result;
    result.m_ = std::numeric_limits<double>::infinity();
    return result;
  }

  [[nodiscard]] bool is_zero() const { return m_ == 0.0; }
  [[nodiscard]] bool is_finite() const { return m_ < std::numeric_limits<double>::infinity(); }

  /// At least this, as a double.
  [[nodiscard]] double rounded_up() const {
    if (m_ == 0.0 || !is_finite()) return m_;
    const int exponent = static_cast<int>(std::clamp<std::int64_t>(exponent_, -1100, 1100));
    const double value = std::ldexp(m_, exponent);
    return value < std::numeric_limits<double>::min() ? value + std::numeric_limits<double>::denorm_min()
                                                      : value;
  }

  friend bool operator<(const Magnitude& x, const Magnitude& y) {
    if (x.is_zero() || !y.is_finite()) return x.m_ < y.m_;
    if (y.is_zero() || !x.is_finite()) return false;
    return x.exponent_ != y.exponent_ ? x.exponent_ < y.exponent_ : x.m_ < y.m_;
  }
  friend Magnitude operator+(const Magnitude& x, const Magnitude& y) {
    if (x < y) return y + x;
    if (y.is_zero() || !x.is_finite()) return x;
    const std::int64_t shift = y.exponent_ - x.exponent_;
    return Magnitude(x.m_ + (shift < -60 ? 0x1p-59 : std::ldexp(y.m_, static_cast<int>(shift))), x.exponent_);
  }
  /// Nothing times infinity is nothing.
  friend Magnitude operator*(const Magnitude& x, const Magnitude& y) {
    if (x.is_zero() || y.is_zero()) return {};
    return Magnitude(x.m_ * y.m_, x.exponent_ + y.exponent_);
  }
  friend Magnitude operator/(const Magnitude& x, const Magnitude& y) {
    if (y.is_zero()) return infinite();
    return y.is_finite() ? Magnitude(x.m_ / y.m_, x.exponent_ - y.exponent_) : Magnitude{};
  }

 private:
  double m_ = 0.0;  // 0, or from 1 to 2, or infinite
  std::int64_t exponent_ = 0;
};

}  // namespace rigor
