// SPDX-License-Identifier: GPL-3.0-or-later
// A small exact fraction, for exponents. What does not fit into 64 bits is no number (`!is_valid()`), and so
// is all that is computed from it.
#pragma once

#include <cstdint>
#include <string>

namespace rigor {

class SmallRational {
 public:
  constexpr SmallRational() = default;
  constexpr SmallRational(std::int64_t whole) : over_(whole) {}  // NOLINT: whole numbers are rational
  SmallRational(std::int64_t over, std::int64_t under);

  [[nodiscard]] std::int64_t over() const { return over_; }
  [[nodiscard]] std::int64_t under() const { return under_; }  // positive; 0 if it is no number
  [[nodiscard]] bool is_valid() const { return under_ != 0; }
  [[nodiscard]] bool is_zero() const { return over_ == 0 && is_valid(); }
  [[nodiscard]] std::string text() const;  // `-3/2`

  friend SmallRational operator+(const SmallRational& a, const SmallRational& b);
  friend SmallRational operator-(const SmallRational& a, const SmallRational& b) {
    return a + b * SmallRational(-1);
  }
  friend SmallRational operator*(const SmallRational& a, const SmallRational& b);
  friend SmallRational operator/(const SmallRational& a, const SmallRational& b);
  friend bool operator==(const SmallRational&, const SmallRational&) = default;

 private:
  std::int64_t over_ = 0;
  std::int64_t under_ = 1;
};

}  // namespace rigor
